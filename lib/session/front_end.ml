open Scc_base
open Scc_syntax

type t = {
  extensions : string list;
  model : Source.t -> (Ast.model, Diag.t list) result;
  expression : Source.t -> (Ast.expr, Diag.t list) result;
  canonical : Source.t -> (string, Diag.t list) result;
}

let shape_calculus =
  let canonical source =
    Result.map (fun (model, trivia) -> Printer.model ~trivia model) (Parse.with_trivia source)
  in
  { extensions = [ ".sc" ]; model = Parse.parse; expression = Parse.expression; canonical }

let all = [ shape_calculus ]
let reads file f = List.exists (Filename.check_suffix file) f.extensions
let has_extension file = List.exists (reads file) all
let of_source source = Option.value (List.find_opt (reads (Source.name source)) all) ~default:shape_calculus
