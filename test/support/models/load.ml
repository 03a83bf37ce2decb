open Scc_base

let read path =
  let ic = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in ic)
    (fun () -> really_input_string ic (in_channel_length ic))

let elaborate ~read_file ~overrides ~name text =
  match Scc_syntax.Parse.parse (Source.make ~name text) with
  | Error _ as e -> e
  | Ok ast -> Scc_elaborate.Elaborate.elaborate ~read_file ~overrides ast

let text ?(name = "model.sc") ?(overrides = []) text =
  elaborate ~read_file:(fun _ -> Error "no files here") ~overrides ~name text

let file ?(overrides = []) path =
  let read_file mesh =
    match read (Filename.concat (Filename.dirname path) mesh) with
    | bytes -> Ok bytes
    | exception Sys_error why -> Error why
  in
  elaborate ~read_file ~overrides ~name:path (read path)

let source name =
  match read name with text -> Some (Source.make ~name text) | exception Sys_error _ -> None

let exactly = function
  | Ok model -> model
  | Error diagnostics -> failwith (String.concat "\n" (List.map (Diag.render ~source) diagnostics))
