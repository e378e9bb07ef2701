said() {
    murk solve fixtures/no_ground.json "$@" --threads 1 -o r.vdb 2>&1 | grep -c '^murk: '
}
[ "$(said -v)" -gt "$(said)" ] && [ "$(said)" -gt "$(said --quiet)" ] && echo "tells more"
