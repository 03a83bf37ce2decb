(* Texts, models and what is known of them, for the tests of this folder. *)

open Scc_base
open Scc_syntax
open Scc_describe
open Scc_assist

let case name f = Alcotest.test_case name `Quick f
let texts = Alcotest.(check (list string))

let read file =
  let channel = open_in_bin file in
  let whole () = really_input_string channel (in_channel_length channel) in
  Fun.protect whole ~finally:(fun () -> close_in channel)

let parts = "param width = 2\nshape Tile(a) = box(a, a, width)\nshape Pin { vertices tip (0,0,1) faces f [tip] }\n"

let modules (i : Ast.import) =
  let text =
    if i.library then Scc_elaborate.Library.find i.from.it
    else if i.from.it = "parts.sc" then Some parts
    else None
  in
  Option.map (fun text -> Reading.make (Source.make ~name:i.from.it text)) text

let reading text = Reading.make (Source.make ~name:"m.sc" text)
let place = Scc_test_support.Piece.place

let models folder =
  let names = List.sort String.compare (Array.to_list (Sys.readdir folder)) in
  let is_model name = Filename.check_suffix name ".sc" in
  List.map (fun name -> (name, read (Filename.concat folder name))) (List.filter is_model names)

let all_models () = models "../../../specs/models" @ models "../../../specs/models/laws"

let load text =
  let source = Source.make ~name:"m.sc" text in
  let read_file path = match path with
    | "parts.sc" -> Ok parts
    | "tiles.sc" -> Ok "param width = 2\nshape Tile(a) = box(a, a, width)\n"
    | _ -> Error "no such file"
  in
  match Scc_loading.Loaded.load ~read_file ~overrides:[] source with
  | Ok l -> l.warnings
  | Error found -> found

let offers text offset = snd (Completion.at (Known.of_text modules (reading text)) text offset)
let names text = List.map (fun (o : Completion.offer) -> o.name) (offers text (String.length text))
