# Sourced by the other scripts, with the root of the project as working directory: installs what is
# missing and nothing else. Silent when everything is there.
#
#   require build   what building and running scc needs
#   require test    that, and what the tests need
#   require package what building scc and making packages needs

build_packages='ocaml-nox ocaml-dune menhir libmenhir-ocaml-dev libzarith-ocaml-dev
  libcmdliner-ocaml-dev libyojson-ocaml-dev libsha-ocaml-dev libbase64-ocaml-dev
  libsqlite3-ocaml-dev libcohttp-lwt-ocaml-dev libzip-ocaml-dev libxmlm-ocaml-dev libjs-codemirror'
test_packages='libalcotest-ocaml-dev libqcheck-core-ocaml-dev ocp-indent python3 python3-jsonschema
  python3-pytest python3-venv python3-setuptools python3-wheel graphviz libxml2-utils zsh fish
  chromium chromium-driver python3-selenium node-typescript e2fsprogs spin
  vim-nox neovim emacs-nox r-base-core r-cran-jsonlite'
package_packages='dpkg-dev git python3 python3-setuptools python3-wheel'

missing_debian_packages() {
  for package in "$@"; do
    status=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null) || status=
    case $status in
      'install ok installed') ;;
      *) echo "$package" ;;
    esac
  done
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null 2>&1; then
    sudo "$@"
  else
    echo "scc needs root (or sudo) once, to run: $*" >&2
    return 1
  fi
}

require_debian() {
  missing=$(missing_debian_packages "$@")
  [ -z "$missing" ] && return 0
  echo 'Installing:' $missing >&2
  as_root apt-get -qq update >&2 || return 1
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get -qq -o Dpkg::Use-Pty=0 install -y --no-install-recommends $missing >/dev/null
}

# from_npm PACKAGE VERSION PART FOLDER: a part of a package that npm has becomes the folder.
from_npm() {
  command -v npm >/dev/null 2>&1 || return 1
  fetched=$(mktemp -d)
  (cd "$fetched" && npm pack --silent "$1@$2" >/dev/null && tar -xzf "$1-$2.tgz") &&
    mkdir -p "$(dirname "$4")" && rm -rf "$4" && cp -r "$fetched/package/$3" "$4"
  code=$?
  rm -rf "$fetched"
  return $code
}

# CodeMirror is the editor of `scc serve`. It is no opam package: npm has it. Without it the desk has a plain field for the
# text.
require_pages() {
  [ -r /usr/share/javascript/codemirror/lib/codemirror.js ] ||
    [ -r "$OPAM_SWITCH_PREFIX/share/scc-codemirror/lib/codemirror.js" ] ||
    from_npm codemirror 5.65.0 . "$OPAM_SWITCH_PREFIX/share/scc-codemirror" ||
    echo 'scc: CodeMirror could not be had (by npm): scc serve will have a plain field for the text' >&2
}

# The stamp spares a second run the half minute that opam takes to find that all is there.
require_opam() {
  stamp="$OPAM_SWITCH_PREFIX/.scc-$1-dependencies"
  [ -e "$stamp" ] && [ ! scc.opam -nt "$stamp" ] && return 0
  case $1 in
    build) opam install --yes --deps-only . ;;
    *) opam install --yes --deps-only --with-test . && opam install --yes ocp-indent ;;
  esac >&2 && touch "$stamp"
}

require() {
  if [ -n "${OPAM_SWITCH_PREFIX:-}" ]; then
    require_opam "$1" && require_pages
  elif command -v apt-get >/dev/null 2>&1; then
    case $1 in
      build) require_debian $build_packages ;;
      package) require_debian $build_packages $package_packages ;;
      *) require_debian $build_packages $test_packages ;;
    esac
  elif command -v opam >/dev/null 2>&1; then
    echo 'No opam switch is active: make one (opam switch create . 4.14.1), then run: eval $(opam env)' >&2
    return 1
  else
    echo 'scc is built with Debian packages (apt-get) or with opam; neither is here.' >&2
    return 1
  fi
}
