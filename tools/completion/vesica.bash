# Completion of vesica for bash: commands, options, case files, templates.

_vesica() {
    local current=$2 previous=$3 command=${COMP_WORDS[1]}
    COMPREPLY=()
    if [[ $COMP_CWORD -eq 1 ]]; then
        mapfile -t COMPREPLY < <(compgen -W "run check resume new info bench reproduce report --help --version" -- "$current")
        return
    fi
    case $previous in
        -o | --output)
            if [[ $command == run || $command == reproduce ]]; then
                mapfile -t COMPREPLY < <(compgen -d -- "$current")
            else
                mapfile -t COMPREPLY < <(compgen -f -- "$current")
            fi
            return
            ;;
        --case)
            mapfile -t COMPREPLY < <(compgen -W "fluid mrt discocyte crowd" -- "$current")
            return
            ;;
        --balance)
            mapfile -t COMPREPLY < <(compgen -W "cells interface" -- "$current")
            return
            ;;
        --watch-address)
            mapfile -t COMPREPLY < <(compgen -W "127.0.0.1 0.0.0.0" -- "$current")
            return
            ;;
        --blocks | --set | --threads | --steps | --size | --colours | --seconds | --triangles | --frames | --max-size | --watch) return ;;
    esac
    local options="--help"
    case $command in
        run) options="--output --set --threads --steps --overwrite --profile --blocks --balance --accept-soft-membranes --watch --watch-address --help" ;;
        check) options="--set --threads --model --accept-soft-membranes --help" ;;
        resume) options="--threads --steps --profile --blocks --balance --help" ;;
        new) options="--list --output --help" ;;
        bench) options="--json --threads --size --case --colours --seconds --help" ;;
        reproduce) options="--all --list --quick --output --threads --help" ;;
        report) options="--output --triangles --frames --max-size --help" ;;
        info) ;;
        *) return ;;
    esac
    if [[ $current == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
        return
    fi
    case $command in
        run | check) mapfile -t COMPREPLY < <(compgen -d -- "$current"; compgen -f -X '!*.toml' -- "$current") ;;
        new) mapfile -t COMPREPLY < <(compgen -W "$(vesica new --list 2>/dev/null | awk '{ print $1 }')" -- "$current") ;;
        reproduce) mapfile -t COMPREPLY < <(compgen -W "$(vesica reproduce --list 2>/dev/null | awk '{ print $1 }')" -- "$current") ;;
        resume | report) mapfile -t COMPREPLY < <(compgen -d -- "$current") ;;
        info) mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
    esac
}
complete -o filenames -F _vesica vesica
