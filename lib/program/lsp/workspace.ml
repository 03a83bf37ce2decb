open Scc_base
open Scc_syntax
open Scc_describe
open Scc_json

type document = {
  uri : string;
  path : string option;
  version : int;
  text : string;
  positions : Positions.t Lazy.t;
  reading : Reading.t;
}

type t = { encoding : Positions.encoding; documents : (string, document) Hashtbl.t }

let create encoding = { encoding; documents = Hashtbl.create 16 }
let encoding t = t.encoding

(* Two addresses of one file are one document. *)
let key uri = Option.value (Uri.path uri) ~default:uri
let has_ending name = List.exists (Filename.check_suffix name) [ ".sc"; ".osc"; ".xml" ]

(* The name of a source tells its notation. *)
let source_name uri = let name = Uri.name uri in if has_ending name then name else name ^ ".sc"

let document encoding ~uri ~version text =
  {
    uri; path = Uri.path uri; version; text;
    positions = lazy (Positions.make encoding text);
    reading = Reading.make (Source.make ~name:(source_name uri) text);
  }

let put t ~uri ~version text = Hashtbl.replace t.documents (key uri) (document t.encoding ~uri ~version text)
let remove t uri = Hashtbl.remove t.documents (key uri)
let find t uri = Hashtbl.find_opt t.documents (key uri)

let all t =
  let found = Hashtbl.fold (fun _ d found -> d :: found) t.documents [] in
  List.sort (fun a b -> String.compare a.uri b.uri) found

(* {1 Files} *)

let most_bytes = 64 * Memory.mib

let of_disk path =
  let read () =
    if Sys.is_directory path then Error "it is a directory"
    else
      match (Unix.stat path).st_kind with
      | S_REG ->
        let file = open_in_bin path in
        let whole () =
          let n = in_channel_length file in
          if n > most_bytes then Error "it is larger than 64 MiB" else Ok (really_input_string file n)
        in
        Fun.protect whole ~finally:(fun () -> close_in_noerr file)
      | _ -> Error "it is no file"
  in
  match read () with
  | result -> result
  | exception (Sys_error _ | End_of_file) -> Error "No such file or directory"
  | exception Unix.Unix_error (e, _, _) -> Error (Unix.error_message e)

let text_of t path =
  match Hashtbl.find_opt t.documents path with Some d -> Ok d.text | None -> of_disk path

let reading_of t path =
  match Hashtbl.find_opt t.documents path with
  | Some d -> Some (d.reading, Lazy.force d.positions)
  | None -> (
      match of_disk path with
      | Error _ -> None
      | Ok text ->
        let d = document t.encoding ~uri:(Uri.of_path path) ~version:0 text in
        Some (d.reading, Lazy.force d.positions))

let resolved ~base file =
  if not (Filename.is_relative file) then Some (Uri.normal file)
  else Option.map (fun base -> Uri.normal (Filename.concat (Filename.dirname base) file)) base

let reader t d file =
  match resolved ~base:d.path file with
  | None -> Error "the document has no folder yet: save it first"
  | Some path -> text_of t path

let imported t ~base (i : Ast.import) =
  if i.library then
    Option.map
      (fun text -> Reading.make (Source.make ~name:i.from.it text))
      (Scc_elaborate.Library.find i.from.it)
  else Option.map fst (Option.bind (resolved ~base i.from.it) (reading_of t))

(* {1 Places} *)

let target t ~base ~file =
  if String.length file > 0 && file.[0] = '<' then None
  else
    let path = if Some file = base then base else resolved ~base file in
    let places path =
      match Hashtbl.find_opt t.documents path with
      | Some d -> Some (d.uri, Lazy.force d.positions)
      | None -> Option.map (fun (_, places) -> (Uri.of_path path, places)) (reading_of t path)
    in
    Option.bind path places

let position (line, character) = `Assoc [ ("line", `Int line); ("character", `Int character) ]

let place places (at : Span.t) : Json.t =
  let side offset = position (Positions.of_offset places offset) in
  `Assoc [ ("start", side at.start); ("end", side at.stop) ]
