#!/bin/sh
# Makes the extension for Visual Studio Code: a file .vsix, which `code --install-extension FILE` installs.
#
#   editors/vscode/package.sh [FILE]       scc.vsix of this folder, if none is named
#   editors/vscode/package.sh --packages   only brings the packages of package-lock.json
#
# It needs node (20 or newer) and npm. Packages and copies are in the folder .made, which nothing else looks into.
set -eu
cd "$(dirname "$0")"
file=${1:-scc.vsix}
case $file in /* | --packages) ;; *) file=$PWD/$file ;; esac

mkdir -p .made
if ! cmp -s package-lock.json .made/package-lock.json || [ ! -e .made/complete ]; then
  rm -f .made/complete
  cp package.json package-lock.json .made
  (cd .made && npm ci --silent --no-audit --no-fund)
  touch .made/complete
fi
[ "$file" != --packages ] || exit 0
rm -rf .made/src .made/snippets .made/syntaxes .made/dist
cp -r package.json README.md language-configuration.json .vscodeignore ../../LICENSE src snippets syntaxes .made
cd .made
npm exec --no -- vsce package --no-dependencies --allow-missing-repository --out "$file"
