open Scc_base
open Scc_syntax

let source text = Source.make ~name:"m.sc" text

let rendered text diagnostics =
  let s = source text in
  String.concat "" (List.map (Diag.render ~source:(fun _ -> Some s)) diagnostics)

let parsed text =
  match Parse.parse (source text) with
  | Ok m -> m
  | Error ds -> Alcotest.fail (rendered text ds)

let parsed_expr text =
  match Parse.expression (source text) with
  | Ok e -> e
  | Error ds -> Alcotest.fail (rendered text ds)

let errors text =
  match Parse.parse (source text) with
  | Ok _ -> Alcotest.fail ("accepted: " ^ text)
  | Error ds -> ds

let summary text diagnostics =
  let s = source text in
  List.map
    (fun (d : Diag.t) ->
       let line, column = Source.position s d.span.start in
       Printf.sprintf "%s %d:%d" d.code line column)
    diagnostics

let contains text part =
  let n = String.length part in
  let rec at i = i + n <= String.length text && (String.equal (String.sub text i n) part || at (i + 1)) in
  at 0
