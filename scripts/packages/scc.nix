# A package for Nix: nix-build scripts/packages/scc.nix
#
# Nix (2.8) has read and evaluated it, with names in place of the packages of Nixpkgs: test/packages/everything does so. It
# was not built, as no channel of Nixpkgs could be reached. Its steps are those of scripts/install.
{ pkgs ? import <nixpkgs> { } }:

let
  ocaml = pkgs.ocamlPackages;
  # (version 0.1.0)
  version = builtins.head (builtins.match ".*\n\\(version ([^)]*)\\)\n.*" (builtins.readFile ../../dune-project));
  # What the build makes is no source.
  source = builtins.filterSource
    (path: type: !(type == "directory" && builtins.match "[_.].*|node_modules" (baseNameOf path) != null))
    ../..;
in
pkgs.stdenv.mkDerivation {
  pname = "scc";
  inherit version;
  src = source;

  nativeBuildInputs = [ ocaml.ocaml ocaml.dune_2 ocaml.findlib ocaml.menhir ];
  buildInputs = with ocaml; [
    base64 camlzip cmdliner cohttp-lwt lwt menhirLib ocaml_sqlite3 sha xmlm yojson zarith
    pkgs.gmp pkgs.libev pkgs.sqlite pkgs.zlib
  ];

  buildPhase = ''
    runHook preBuild
    dune build --profile release --build-dir _release bin/main.exe
    runHook postBuild
  '';

  installPhase = ''
    runHook preInstall
    patchShebangs scripts
    SCC=$PWD/_release/default/bin/main.exe scripts/install $out
    mkdir -p $out/share/scc
    cp -R specs/models $out/share/scc/models
    runHook postInstall
  '';

  doInstallCheck = true;
  installCheckPhase = "$out/bin/scc check $out/share/scc/models/hexokinase.sc || [ $? -eq 1 ]";

  meta = {
    description = "Reference interpreter and model checker for the Shape Calculus";
    license = "Apache-2.0";
    mainProgram = "scc";
  };
}
