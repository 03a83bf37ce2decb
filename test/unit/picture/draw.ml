(* Draws the state in which a model is declared. *)

open Scc_loading

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let () =
  let path = Sys.argv.(1) in
  let source = Scc_base.Source.make ~name:path (read path) in
  match Loaded.load ~read_file:(fun _ -> Error "no meshes here") ~overrides:[] source with
  | Error diagnostics ->
    List.iter (fun d -> prerr_endline (Scc_base.Diag.render ~source:(fun _ -> Some source) d)) diagnostics;
    exit 1
  | Ok l ->
    let v = Scc_exact.Vec.of_ints in
    let options =
      { Scc_picture.Picture.default with from = v 2 (-5) 3; up = v 0 0 1; names = true; title = Some "A scene" }
    in
    print_string (Scc_picture.Picture.svg l.model l.declared options)
