open Scc_exact
open Text

type t = { points : word list; index : word list; ccw : bool; name : string option }

let blank c = c = ' ' || c = '\t' || c = '\n' || c = '\r' || c = ',' || c = '\x0c'

let words text start stop =
  let rec skip acc i =
    if i >= stop then List.rev acc else if blank text.[i] then skip acc (i + 1) else word acc i i
  and word acc start i =
    if i >= stop || blank text.[i] then skip ({ text = String.sub text start (i - start); start } :: acc) i
    else word acc start (i + 1)
  in
  skip [] start

let identity = function
  | "translation" | "center" -> Some Rat.zero
  | "scale" -> Some Rat.one
  | _ -> None

let moves ~path key values =
  let* numbers = Result.all (coordinate ~path) values in
  match (identity key, numbers) with
  | Some expected, [ x; y; z ] -> Ok (not (List.for_all (Rat.equal expected) [ x; y; z ]))
  | None, [ _; _; _; angle ] -> Ok (Rat.sign angle <> 0)
  | _ -> Ok true

let rec points ~path acc = function
  | [] -> Ok acc
  | x :: y :: z :: rest -> (
      match coordinates ~path [ x; y; z ] with
      | Ok v -> points ~path (v :: acc) rest
      | Error _ as e -> e)
  | w :: _ -> error ~path w "the number of coordinates is not a multiple of three"

(* Faces in reverse order; [corners] are those of the face that is open, in reverse order. *)
let rec faces ~path ~name ~ccw ~first ~count acc corners = function
  | [] -> Ok acc
  | { text = "-1"; _ } as w :: rest -> (
      match corners with
      | _ :: _ :: _ :: _ ->
        let face = Array.of_list (if ccw then List.rev corners else corners) in
        faces ~path ~name ~ccw ~first ~count ((name, face) :: acc) [] rest
      | [] -> faces ~path ~name ~ccw ~first ~count acc [] rest
      | _ -> error ~path w "a face needs at least three corners, not %d" (List.length corners))
  | w :: rest -> (
      match vertex ~path ~count w with
      | Ok i -> faces ~path ~name ~ccw ~first ~count acc ((first + i) :: corners) rest
      | Error _ as e -> e)

(* The last face of a set needs no -1: it is put there. *)
let closed index =
  match List.rev index with
  | [] | { text = "-1"; _ } :: _ -> index
  | last :: _ as reversed -> List.rev ({ last with text = "-1" } :: reversed)

let add ~path (first, all, all_faces) set =
  let* all = points ~path all set.points in
  let count = List.length set.points / 3 in
  let* all_faces = faces ~path ~name:set.name ~ccw:set.ccw ~first ~count all_faces [] (closed set.index) in
  Ok (first + count, all, all_faces)

let to_ifs ~path sets =
  match sets with
  | [] -> error_at ~path 0 "the file has no IndexedFaceSet"
  | _ :: _ ->
    let step acc set = Result.bind acc (fun acc -> add ~path acc set) in
    let* _, vertices, faces = List.fold_left step (Ok (0, [], [])) sets in
    Ok (labelled vertices faces)
