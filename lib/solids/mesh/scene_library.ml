open Scc_base
open Scc_exact

type prototype = {
  fields : Scene.fields;
  body : path:string -> Text.word -> depth:int -> Scene.fields -> Scene.node * Scene.change list;
}

type file = { prototypes : (string * (depth:int -> prototype)) list; length : Rat.t }

type t = {
  files : Beside.reader;
  room : int ref;
  read : t -> path:string -> start:int -> depth:int -> string -> file;
  loaded : (string, file) Hashtbl.t;
  mutable loading : string list;
  mutable following : int;  (* declarations that lead to each other *)
  mutable starts : (int * string) list;  (* of files, the last one first *)
  mutable next : int;
}

(* Beyond the places of any file. *)
let first_start = 1 lsl 40

let make ~files ~room ~read =
  {
    files; room; read; loaded = Hashtbl.create 8; loading = []; following = 0; starts = []; next = first_start;
  }

let file ~units ~own ~elsewhere prototypes =
  let one (name, prototype) =
    let made ~depth =
      match prototype with
      | Scene.Own { fields; body } -> own name fields body
      | Elsewhere e -> elsewhere ~depth e
      | Inside -> Bug.fail __POS__ "a prototype around a file"
    in
    (name, made)
  in
  { prototypes = List.rev_map one prototypes; length = Scene_unit.length units }

let files t = t.files
let room t = t.room

(* {1 Places} *)

let start_of t place =
  if place < first_start then None else List.find_opt (fun (start, _) -> start <= place) t.starts

let path_of t ~path (w : Text.word) = match start_of t w.start with Some (_, path) -> path | None -> path

let located t (d : Diag.t) =
  match start_of t d.span.start with
  | Some (start, file) ->
    { d with span = Span.make ~file ~start:(d.span.start - start) ~stop:(d.span.stop - start) }
  | None -> d

(* {1 Files} *)

let strings words =
  let text = String.concat " " (List.map (fun (w : Text.word) -> w.text) words) in
  if String.contains text '"' then List.filteri (fun i _ -> i land 1 = 1) (String.split_on_char '"' text)
  else List.filter (( <> ) "") (String.split_on_char ' ' text)

let file_of url = List.hd (String.split_on_char '#' url)

let elsewhere ~path ~name (at : Text.word) words =
  let at = match words with first :: _ -> first | [] -> at in
  { Scene.path; name; at; urls = strings words }

let most_followed = 32

let refuse (e : Scene.elsewhere) fmt =
  Scene.unread ~path:e.path e.at
    ~hint:"put the declaration of the prototype into this file, or that file beside this one" fmt

let load t ~depth (e : Scene.elsewhere) path text =
  match Hashtbl.find_opt t.loaded path with
  | Some file -> file
  | None ->
    let text = Source.blank_mark text in
    let start = t.next and around = t.loading in
    t.next <- start + String.length text + 1;
    t.starts <- (start, path) :: t.starts;
    t.room := !(t.room) + (4 * String.length text);
    Scene.spend ~path:e.path t.room e.at 100;
    t.loading <- path :: around;
    let file = t.read t ~path ~start ~depth text in
    t.loading <- around;
    Hashtbl.replace t.loaded path file;
    file

(* The one of that name, or the first one. *)
let chosen (e : Scene.elsewhere) url file =
  match (String.index_opt url '#', file.prototypes) with
  | None, (_, first) :: _ -> first
  | None, [] -> refuse e "the file %s has no prototype" (Text.quote (file_of url))
  | Some i, all -> (
      let name = String.sub url (i + 1) (String.length url - i - 1) in
      match List.assoc_opt name all with
      | Some found -> found
      | None ->
        let file = file_of url in
        refuse e "the file %s has no prototype of the name %s" (Text.quote file) (Text.quote name))

let find t ~depth ~length (e : Scene.elsewhere) =
  let one url =
    Result.bind (Beside.path ~path:e.path (file_of url)) (fun path ->
        Result.map (fun text -> (path, text)) (if Hashtbl.mem t.loaded path then Ok "" else t.files path))
  in
  let rec first why = function
    | [] -> (
        match why with
        | Some (url, why) ->
          let name = Text.quote e.name in
          refuse e "the prototype %s is in the file %s, which is not read: %s" name (Text.quote url) why
        | None -> refuse e "the prototype %s is in another file, which is not named" (Text.quote e.name))
    | url :: rest -> (
        match one url with
        | Error text -> first (if Option.is_some why then why else Some (url, text)) rest
        | Ok (path, _) when List.mem path t.loading -> refuse e "the file %s needs itself here" (Text.quote url)
        | Ok (path, text) -> (url, load t ~depth e path text))
  in
  if t.following >= most_followed then
    refuse e "prototypes in other files lead to each other more than %d times" most_followed;
  t.following <- t.following + 1;
  let url, file = first None e.urls in
  if not (Rat.equal file.length length) then
    refuse e "the prototype %s is in a file with another unit of length" (Text.quote e.name);
  let found = chosen e url file ~depth in
  t.following <- t.following - 1;
  found
