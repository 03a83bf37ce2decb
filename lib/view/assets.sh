#!/bin/sh
# Writes the parts of the page as a module of OCaml: `assets.sh WEB`, with the folder of its sources.
#
# three.js draws the scene. It is where SCC_THREE says, where Debian's package libjs-three has it, or where
# scripts/dependencies.sh put it in an opam switch; without it the page has everything but the scene, and says so.
set -eu
web=$1
three=${SCC_THREE:-/usr/share/javascript/three/three.min.js}
[ -r "$three" ] || three=${OPAM_SWITCH_PREFIX:-}/share/scc-three/three.min.js

# text NAME FILE
text() {
  printf 'let %s = {scc_asset|' "$1"
  cat "$2"
  printf '|scc_asset}\n\n'
}

script() {
  printf '    ("%s", {scc_asset|' "$(basename "$1")"
  cat "$1"
  printf '|scc_asset});\n'
}

text page "$web/page.html"
text style "$web/page.css"
echo 'let scripts ='
echo '  ['
[ ! -r "$three" ] || script "$three"
while read -r name; do script "$web/$name"; done < "$web/scripts"
echo '  ]'
