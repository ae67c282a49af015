# Fetches the locked libraries when they are not there or not those of the lock file, then bundles the page.
# A machine without network still gets everything but the page.
file(LOCK "${REPORT}" DIRECTORY GUARD PROCESS TIMEOUT 300) # two builds may share the sources
file(SHA256 "${REPORT}/package-lock.json" wanted)
set(stamp "${REPORT}/node_modules/.vesica-lock")
set(present "")
if(EXISTS "${stamp}")
    file(READ "${stamp}" present)
endif()
if(NOT present STREQUAL wanted)
    execute_process(COMMAND "${NPM}" ci --ignore-scripts --no-audit --no-fund --loglevel=error
        WORKING_DIRECTORY "${REPORT}" RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE words)
    if(failed)
        message(WARNING "npm cannot fetch the libraries of the report's page, so `vesica report` will not work; "
            "the next build tries again. It said:\n${words}")
        return()
    endif()
    file(WRITE "${stamp}" "${wanted}")
endif()
execute_process(COMMAND "${NODE}" build.mjs "${PAGE}" WORKING_DIRECTORY "${REPORT}" COMMAND_ERROR_IS_FATAL ANY)
