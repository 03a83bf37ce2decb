type kind = File of { over : string option } | Folder | Store
type output = { option : string; path : string; kind : kind }
type t = output list

let none = []

let file ?(over = None) option path =
  match path with
  | None | Some "-" -> []
  | Some path -> [ { option; path; kind = File { over } } ]

let into kind option path = Option.to_list (Option.map (fun path -> { option; path; kind }) path)
let folder = into Folder
let store = into Store "--store"

(* {1 One file} *)

type place = Inode of int * int | Name of string | Device

(* A file that is not there yet has its name in a folder that is. *)
let named path =
  let path = Whole_file.target path in
  let folder = try Unix.realpath (Filename.dirname path) with Unix.Unix_error _ -> Filename.dirname path in
  Filename.concat folder (Filename.basename path)

let place path =
  match Unix.stat path with
  | { st_kind = S_REG | S_DIR; st_dev; st_ino; _ } -> Inode (st_dev, st_ino)
  | _ -> Device
  | exception Unix.Unix_error _ -> Name (named path)

let same a b =
  match (a, b) with
  | Inode (d, i), Inode (e, j) -> d = e && i = j
  | Name m, Name n -> String.equal m n
  | (Inode _ | Name _ | Device), _ -> false

let is_same path other = same (place path) (place other)

let rec is_below folder path =
  let above = Filename.dirname path in
  (not (String.equal above path)) && (same folder (place above) || is_below folder above)

let is_in folder path = is_below (place folder) (named path)
let is_folder o = match o.kind with Folder | Store -> true | File _ -> false

(* {1 What does not go together} *)

let clash a b =
  if is_same a.path b.path then
    let what = if is_folder a && is_folder b then "folder" else "file" in
    Some (Printf.sprintf "%s and %s name the same %s" a.option b.option what)
  else
    let within a b =
      if b.kind = Store && is_in b.path a.path then
        Some (Printf.sprintf "%s is in the folder of %s, which has files of its own" a.option b.option)
      else None
    in
    match within a b with None -> within b a | found -> found

let rec add t = function
  | [] -> Ok t
  | next :: rest -> (
      match List.find_map (fun before -> clash before next) t with
      | Some text -> Error text
      | None -> add (t @ [ next ]) rest)

let is_written o = o.kind <> Store
let some t = List.exists is_written t
let others t path = List.exists (fun o -> is_written o && not (String.equal o.path path)) t

let refusal t input =
  let t = if String.equal input "-" then none else t in
  let overwrites o =
    match o.kind with
    | File { over } ->
      let in_place over =
        is_same over input && String.equal (Filename.extension o.path) (Filename.extension over)
      in
      is_same o.path input && not (Option.fold ~none:false ~some:in_place over)
    | Folder -> false
    | Store -> is_in o.path input
  in
  match List.find_opt overwrites t with
  | None -> None
  | Some { option; kind = File _; _ } ->
    Some (Printf.sprintf "%s would overwrite %s, which is read: give another name" option input)
  | Some { option; kind = Folder | Store; _ } ->
    Some (Printf.sprintf "%s is read, and is in the folder of %s: give another folder" input option)
