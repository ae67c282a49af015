# Fetches the locked libraries when they are not there or not those of the lock file, then bundles the page.
# A machine without network still gets everything but the page.
file(LOCK "${REPORT}" DIRECTORY GUARD PROCESS TIMEOUT 300 RESULT_VARIABLE locked) # two builds may share the sources
if(NOT locked EQUAL 0)
    message(WARNING "${REPORT} cannot be locked (${locked}), so the report's page is not built and `vesica report` will not "
        "work; expected sources that can be written to and no other build of the page; the next build tries again")
    return()
endif()
file(READ "${REPORT}/package.json" package)
string(JSON needed GET "${package}" engines node)
string(REGEX MATCH "[0-9.]+" least "${needed}")
execute_process(COMMAND "${NODE}" --version RESULT_VARIABLE failed OUTPUT_VARIABLE found ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
string(REGEX REPLACE "^v" "" version "${found}")
if(failed OR version VERSION_LESS least)
    message(WARNING "${NODE} is node ${found}; the report's page wants node ${needed}, so it is not built and `vesica report` will "
        "not work; install such a one, as Debian 12's package nodejs is, or set VESICA_NODE and VESICA_NPM")
    return()
endif()
file(SHA256 "${REPORT}/package-lock.json" wanted)
set(stamp "${REPORT}/node_modules/.vesica-lock")
set(present "")
if(EXISTS "${stamp}")
    file(READ "${stamp}" present)
endif()
if(NOT present STREQUAL wanted)
    execute_process(COMMAND "${NPM}" ci --ignore-scripts --no-audit --no-fund --loglevel=error --prefer-offline
            --fetch-retries=1 --fetch-retry-mintimeout=1000 --fetch-retry-maxtimeout=5000 --fetch-timeout=30000
        WORKING_DIRECTORY "${REPORT}" RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE words)
    if(failed)
        message(WARNING "npm cannot fetch the libraries of the report's page, so `vesica report` will not work; "
            "the next build tries again. It said:\n${words}")
        return()
    endif()
    file(WRITE "${stamp}" "${wanted}")
endif()
execute_process(COMMAND "${NODE}" build.mjs "${PAGE}" WORKING_DIRECTORY "${REPORT}" RESULT_VARIABLE failed)
if(failed)
    message(FATAL_ERROR "the report's page cannot be bundled (${failed})")
endif()
