open Scc_base
open Scc_syntax

type t = {
  name : string;
  told : string;
  extensions : string list;
  read : Source.t -> (Ast.model * Trivia.t list, Diag.t list) result;
  write : Ast.model * Trivia.t list -> (string, Diag.t list) result;
  canonical : Source.t -> (string, Diag.t list) result;
  as_written : Source.t -> (Ast.model * Trivia.t list, Diag.t list) result;
  readable : Source.t -> Ast.model;
}

let again read write source = Result.bind (read source) write

let shape_calculus =
  let write (model, trivia) = Ok (Printer.model ~trivia model) in
  {
    name = "sc";
    told = "the language of scc";
    extensions = [ ".sc" ];
    read = (fun source -> Parse.with_trivia source);
    write;
    canonical = again (fun source -> Parse.with_trivia source) write;
    as_written = (fun source -> Parse.with_trivia source);
    readable = (fun source -> Parse.readable source);
  }

let bioshape =
  let write (model, trivia) = Scc_bioshape.Write.model ~trivia model in
  {
    name = "xml";
    told = "XML after BioShape's, by a schema of our own: specs/schema/bioshape.xsd";
    extensions = [ ".xml" ];
    read = Scc_bioshape.Read.with_trivia;
    write;
    canonical = again Scc_bioshape.Read.with_trivia write;
    as_written = Scc_bioshape.Read.with_trivia;
    readable = Scc_bioshape.Read.readable;
  }

let original =
  {
    name = "original";
    told = "the original Shape Calculus, with regions of contact as sets of points: specs/original.md";
    extensions = [ ".osc" ];
    read = Scc_original.Original.read;
    write = Scc_original.Original.write;
    canonical = Scc_original.Original.canonical;
    as_written = Scc_original.Original.as_written;
    readable = Scc_original.Original.readable;
  }

let all = [ shape_calculus; bioshape; original ]
let has_extension file n = List.exists (Filename.check_suffix file) n.extensions
let of_name file = List.find_opt (has_extension file) all

let of_source source =
  match of_name (Source.name source) with
  | Some n -> n
  | None -> if Scc_bioshape.Read.begins (Source.text source) then bioshape else shape_calculus

let model source = Result.map fst ((of_source source).read source)

let readable source = (of_source source).readable source

let canonical source = (of_source source).canonical source
