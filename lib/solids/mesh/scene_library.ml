open Scc_base
open Scc_exact

type prototype = {
  interface : Scene.interface;
  fields : Scene.fields;
  body : path:string -> Text.word -> depth:int -> Scene.fields -> Scene.node * Scene.change list;
}

type declared = { name : string; own : bool; made : depth:int -> prototype }
type file = { prototypes : declared list; length : Rat.t }

type t = {
  files : Beside.reader;
  room : int ref;
  read : t -> path:string -> start:int -> depth:int -> string -> file;
  loaded : (string, file) Hashtbl.t;
  mutable loading : string list;
  mutable following : int;  (* declarations that lead to each other *)
  mutable expanding : (string * string) list;  (* files and prototypes whose bodies are read *)
  mutable starts : (int * string) list;  (* of files, the last one first *)
  mutable next : int;
}

(* Beyond the places of any file. *)
let first_start = 1 lsl 40

let make ~files ~room ~read =
  {
    files; room; read; loaded = Hashtbl.create 8; loading = []; following = 0; expanding = []; starts = [];
    next = first_start;
  }

let file ~units ~own ~elsewhere prototypes =
  let one (name, prototype) =
    let is_own = match prototype with Scene.Own _ -> true | Elsewhere _ | Inside -> false in
    let made ~depth =
      match prototype with
      | Scene.Own { interface; fields; body } -> own name interface fields body
      | Elsewhere e -> elsewhere ~depth e
      | Inside -> Bug.fail __POS__ "a prototype around a file"
    in
    { name; own = is_own; made }
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

let elsewhere ~path ~name ~interface (at : Text.word) words =
  let at = match words with first :: _ -> first | [] -> at in
  { Scene.path; name; at; interface; urls = strings words }

let most_followed = 32

let refuse (e : Scene.elsewhere) ~hint fmt = Scene.unread ~path:e.path e.at ~hint fmt
let not_there = "put the declaration of the prototype into this file, or that file beside this one"

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

let most_listed = 8

let listed all =
  let names = List.filteri (fun i _ -> i < most_listed) (List.map Text.quote all) in
  let more = List.length all - List.length names in
  String.concat ", " names ^ if more > 0 then Printf.sprintf " and %d more" more else ""

(* The one of that name, or the first one whose body is in the file. *)
let chosen (e : Scene.elsewhere) url file =
  let path = Text.quote (file_of url) and names = listed (List.map (fun p -> p.name) file.prototypes) in
  match (String.index_opt url '#', file.prototypes) with
  | _, [] -> refuse e ~hint:not_there "the file %s has no prototype" path
  | None, all -> (
      match List.find_opt (fun p -> p.own) all with
      | Some first -> first.made
      | None ->
        refuse e ~hint:("write a `#` after the file and one of these names: " ^ names)
          "an address without a name means the first PROTO, and the file %s has no PROTO of its own" path)
  | Some i, all -> (
      let name = String.sub url (i + 1) (String.length url - i - 1) in
      let of_name name = List.find_opt (fun p -> String.equal p.name name) all in
      match (match of_name name with None -> of_name (Percent.decoded name) | found -> found) with
      | Some found -> found.made
      | None ->
        refuse e ~hint:("write one of the names that are there: " ^ names)
          "the file %s has no prototype of the name %s" path (Text.quote name))

(* What is declared at the place of use is a part of what the prototype has (ISO 14772-1, 4.9.1). *)
let check_interface (e : Scene.elsewhere) url (found : Scene.interface) =
  let fits (here : Scene.declared) (there : Scene.declared) =
    match (here.access, there.access) with
    | Unsaid, _ | _, (Unsaid | Exposed) -> true
    | (Field | Exposed), Field | In, In | Out, Out -> true
    | (Field | Exposed), (In | Out) | (In | Out), Field | In, Out | Out, In -> false
  in
  let event (here : Scene.declared) (there : Scene.declared) =
    let name = there.field.text in
    match (there.access, here.access) with
    | (Exposed | Unsaid), In -> String.equal here.field.text ("set_" ^ name)
    | (Exposed | Unsaid), Out -> String.equal here.field.text (name ^ "_changed")
    | _ -> false
  in
  let one (here : Scene.declared) =
    let own (there : Scene.declared) = String.equal here.field.text there.field.text in
    let name = Text.quote here.field.text and file = Text.quote url in
    let found = match List.find_opt own found with None -> List.find_opt (event here) found | own -> own in
    match found with
    | None -> Scene.bad ~path:e.path here.field "the prototype in the file %s has no field %s" file name
    | Some there when here.type_ <> "" && there.type_ <> "" && not (String.equal here.type_ there.type_) ->
      Scene.bad ~path:e.path here.field "%s is of the type %s here, and of the type %s in the file %s" name
        here.type_ there.type_ file
    | Some there when not (fits here there) ->
      Scene.bad ~path:e.path here.field "%s is %s here, and %s in the file %s" name
        (Scene.access_name here.access) (Scene.access_name there.access) file
    | Some _ -> ()
  in
  List.iter one e.interface

let need_each_other =
  "put the prototypes that need each other into one file; where one of them uses itself in the end, remove that \
   use"

let name_of (e : Scene.elsewhere) url =
  match String.index_opt url '#' with
  | Some i -> Percent.decoded (String.sub url (i + 1) (String.length url - i - 1))
  | None -> e.name

(* The values of fields are read before a body is, and so this one is around the place where it is read again. *)
let once t (e : Scene.elsewhere) (key : string * string) body ~path kind ~depth fields =
  if List.mem key t.expanding then begin
    (* From the outer ones to the inner ones. *)
    let rec up_to found = function
      | other :: rest when other <> key -> up_to (Text.quote (snd other) :: found) rest
      | _ -> found
    in
    let way =
      match up_to [] t.expanding with
      | [] -> ""
      | names -> ", by way of " ^ String.concat ", " names
    in
    refuse e ~hint:"remove one of these uses: a prototype has no end that has itself in its body"
      "the prototype %s uses itself%s" (Text.quote (snd key)) way
  end;
  let around = t.expanding in
  t.expanding <- key :: around;
  let found = body ~path kind ~depth fields in
  t.expanding <- around;
  found

let find t ~depth ~length (e : Scene.elsewhere) =
  let text path = if Hashtbl.mem t.loaded path then Ok "" else t.files path in
  let one url = Beside.address text ~path:e.path (file_of url) in
  let rec first why = function
    | [] -> (
        match why with
        | Some (url, why) ->
          let name = Text.quote e.name in
          refuse e ~hint:not_there "the prototype %s is in the file %s, which is not read: %s" name
            (Text.quote url) why
        | None ->
          refuse e ~hint:"write the address of that file after the fields of the prototype"
            "the prototype %s is in another file, which is not named" (Text.quote e.name))
    | url :: rest -> (
        match one url with
        | Error text -> first (if Option.is_some why then why else Some (url, text)) rest
        | Ok (path, _) when List.mem path t.loading ->
          refuse e ~hint:need_each_other "the file %s needs itself here"
            (Text.quote url)
        | Ok (path, text) -> (url, path, load t ~depth e path text))
  in
  if t.following >= most_followed then
    refuse e ~hint:"end the cycle: write the address of the file that has the body of the prototype"
      "prototypes in other files lead to each other more than %d times" most_followed;
  t.following <- t.following + 1;
  let url, path, file = first None e.urls in
  if not (Rat.equal file.length length) then
    refuse e ~hint:"write the lengths in both files in one unit, and state it in both"
      "the prototype %s is in a file with another unit of length" (Text.quote e.name);
  let found = chosen e url file ~depth in
  check_interface e url found.interface;
  t.following <- t.following - 1;
  { found with interface = e.interface; body = once t e (path, name_of e url) found.body }
