open Scc_base
open Scc_system

let max_bytes = 64 * Memory.mib

let too_large max_bytes = Printf.sprintf "it is larger than %d MiB" (max_bytes / Memory.mib)

(* Devices and pipes do not tell their size, so the size is counted while reading. *)
let slurp ~max_bytes file =
  let b = Buffer.create 65536 in
  let chunk = Bytes.create 65536 in
  let rec more () =
    match Reading.some file chunk 0 (Bytes.length chunk) with
    | 0 -> Ok (Buffer.contents b)
    | n ->
      Buffer.add_subbytes b chunk 0 n;
      if Buffer.length b > max_bytes then Error (too_large max_bytes) else more ()
  in
  more ()

(* Pipes, terminals and devices may have to be waited for, and nothing can be reported before. A file is there: an
   interruption leaves it to be read, so that a report says what is known. *)
let may_wait path =
  String.equal path "-"
  ||
  match (Unix.stat path).st_kind with
  | S_REG | S_DIR -> false
  | S_CHR | S_BLK | S_LNK | S_FIFO | S_SOCK -> true
  | exception Unix.Unix_error _ -> false

let bytes ?(max_bytes = max_bytes) path =
  let read () =
    match
      if String.equal path "-" then slurp ~max_bytes Unix.stdin
      else if (try Sys.is_directory path with Sys_error _ -> false) then Error "it is a directory"
      else
        let file = Reading.open_file path in
        Fun.protect (fun () -> slurp ~max_bytes file) ~finally:(fun () -> Unix.close file)
    with
    | result -> result
    (* It says nothing of the file that the system has no more to give. *)
    | exception (Unix.Unix_error (e, _, _) as failure) when Option.is_none (Resources.refused failure) ->
      Error (Unix.error_message e)
  in
  if may_wait path then Interruption.at_once read else read ()

let standard_input = "<standard input>"

let cannot_read ?hint name reason =
  Diag.error ?hint Code.cannot_read (Span.of_file name) "cannot read: %s" reason

let read ?(max_bytes = max_bytes) ?smaller console path =
  Console.reads console path;
  let name = if String.equal path "-" then standard_input else path in
  match bytes ~max_bytes path with
  | Ok text -> Ok (Source.make ~name text)
  | Error reason ->
    let hint = if String.equal reason (too_large max_bytes) then smaller else None in
    Error (cannot_read ?hint name reason)

let text ?smaller console path =
  let* source = Result.listed (read ?smaller console path) in
  Console.add_source console source;
  Ok source

let warned console path =
  let* source = text console path in
  Console.report console (Direction.warnings source);
  Ok source

let given console ~name text =
  let source = Source.make ~name text in
  Console.add_source console source;
  Console.report console (Direction.warnings source);
  source

(* For the places of its errors. *)
let told console ~name path =
  Console.reads console path;
  Result.map
    (fun text ->
       if Option.is_none (Console.source console name) then
         Console.add_source console (Source.make ~name text);
       text)
    (bytes path)

let beside console path = told console ~name:path path

let mesh_reader console model name =
  told console ~name (if Filename.is_relative name then Filename.concat (Filename.dirname model) name else name)

(* Two values for one parameter: neither can be meant. *)
let rec check_overrides = function
  | [] -> Ok ()
  | name :: rest ->
    if List.exists (String.equal name) rest then
      let at = Span.command_line in
      Error [ Diag.error Code.repeated_attribute at "the parameter `%s` is given two values by -D" name ]
    else check_overrides rest

(* The model knows the value alone, and not where it comes from. *)
let placed given (d : Diag.t) =
  let of_parameters = [ (Code.unknown_parameter :> string); (Code.bad_range :> string) ] in
  if Span.is_none d.span && List.mem d.code of_parameters then { d with span = given }
  else d

let report console (l : Scc_loading.Loaded.t) diagnostics =
  Console.report console (List.map (Diag.of_file (Source.name l.source)) diagnostics)

let no_check code at name checks =
  let names = List.map (fun (c : Scc_property.Property.check) -> c.name) checks in
  Diag.error code at ?hint:(Diag.suggest name names) "the model has no check `%s`" name

let model ?(given = Span.command_line) ?(narrowed = []) ?parametric ?source ?read_file console ~overrides path =
  let read_file = Option.value read_file ~default:(mesh_reader console path) in
  let* () = check_overrides (List.map fst overrides @ List.map fst narrowed) in
  let* source =
    match source with
    | None -> text console path
    | Some source ->
      Console.add_source console source;
      Ok source
  in
  (* A model of thousands of bodies takes seconds. *)
  Console.phase console "reading the model";
  let loaded = Scc_loading.Loaded.load ~read_file ~overrides ~narrowed ?parametric source in
  Console.progress_done console;
  Result.map_error (List.map (placed given)) loaded
