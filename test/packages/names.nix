# Evaluates the recipe for Nix with names in place of the packages of Nixpkgs, which is not here.
let
  all = names: builtins.listToAttrs (map (n: { name = n; value = n; }) names);
in import ../../scripts/packages/scc.nix {
  pkgs = all [ "gmp" "libev" "sqlite" "zlib" ] // {
    ocamlPackages = all [ "ocaml" "dune_2" "findlib" "menhir" "base64" "camlzip" "cmdliner" "cohttp-lwt" "lwt" "menhirLib" "ocaml_sqlite3" "sha" "xmlm" "yojson" "zarith" ];
    stdenv.mkDerivation = x: builtins.removeAttrs x [ "src" ];
  };
}
