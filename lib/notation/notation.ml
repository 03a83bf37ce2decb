open Scc_base
open Scc_syntax

type t = {
  name : string;
  told : string;
  extensions : string list;
  read : Source.t -> (Ast.model * Trivia.t list, Diag.t list) result;
  write : Ast.model * Trivia.t list -> (string, Diag.t list) result;
  readable : Source.t -> Ast.model;
}

let shape_calculus =
  let write (model, trivia) = Ok (Printer.model ~trivia model) in
  {
    name = "sc";
    told = "the language of scc";
    extensions = [ ".sc" ];
    read = Parse.with_trivia;
    write;
    readable = Parse.readable;
  }

let bioshape =
  {
    name = "xml";
    told = "XML after BioShape's, by a schema of our own: specs/schema/bioshape.xsd";
    extensions = [ ".xml" ];
    read = Scc_bioshape.Read.with_trivia;
    write = (fun (model, trivia) -> Scc_bioshape.Write.model ~trivia model);
    readable = Scc_bioshape.Read.readable;
  }

let all = [ shape_calculus; bioshape ]
let has_extension file n = List.exists (Filename.check_suffix file) n.extensions
let of_name file = List.find_opt (has_extension file) all

let of_source source =
  match of_name (Source.name source) with
  | Some n -> n
  | None -> if Scc_bioshape.Read.begins (Source.text source) then bioshape else shape_calculus

let model source = Result.map fst ((of_source source).read source)

let readable source = (of_source source).readable source

let canonical source =
  let notation = of_source source in
  Result.bind (notation.read source) notation.write
