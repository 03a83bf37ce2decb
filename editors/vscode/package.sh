#!/bin/sh
# Makes the extension for Visual Studio Code: a file .vsix, which `code --install-extension FILE` installs.
#
#   editors/vscode/package.sh [FILE]    scc.vsix of this folder, if none is named
#
# It needs node (20 or newer) and npm, which brings the packages of package-lock.json.
set -eu
cd "$(dirname "$0")"
[ -d node_modules ] && [ node_modules/.package-lock.json -nt package-lock.json ] || npm ci --silent --no-audit --no-fund
cp ../../LICENSE LICENSE
trap 'rm -f LICENSE' EXIT
npm exec --no -- vsce package --no-dependencies --allow-missing-repository --out "${1:-scc.vsix}"
