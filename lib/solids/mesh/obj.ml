open Scc_base
open Text

type state = {
  vertices : Scc_exact.Vec.t list;  (* in reverse order *)
  count : int;
  left_out : word option;  (* the first line or point *)
  odd : word option;
  (* the first normal or place in a picture that is none, or that a face names and is not there *)
  textures : int;
  normals : int;
  named : (word * int * [ `Texture | `Normal ]) list;  (* further on in the file, perhaps *)
  objects : string option;  (* the one that faces now belong to *)
  groups : string option;
  faces : (string option * (word * int) array) list;
  (* labels and corners, in reverse order of faces: the word, and the index from 0 (which may be that of a vertex
     further on) *)
}

type treatment = Read | Still | Left_out | Refused of string

let curves = "curves and surfaces are not read: make faces of them first"

(* All statements of the specification: what is read; what says how faces look, or is used by curves alone; lines
   and points; and what makes other shapes. *)
let keywords =
  let all treatment words = List.map (fun w -> (w, treatment)) (String.split_on_char ' ' words) in
  all Read "v f fo g o"
  @ all Still
    "s usemtl mtllib usemap maplib vt vn vp mg lod bevel c_interp d_interp shadow_obj trace_obj ctech stech"
  @ all Left_out "l p"
  @ all (Refused curves)
    "curv curv2 surf parm trim hole scrv sp end con cstype deg bmat step bsp bzp cdc cdp res"
  @ all (Refused "statements in other files are not read: put them into this one") "call"
  @ all (Refused "commands of a system are not run") "csh"

(* x y z, then nothing, a weight that must be one, or a colour (three or four numbers). *)
let vertex_statement ~path keyword state words =
  match words with
  | [ _; _; _ ] | [ _; _; _; _; _; _ ] | [ _; _; _; _; _; _; _ ] ->
    let* v = coordinates ~path words in
    Ok { state with vertices = v :: state.vertices; count = state.count + 1 }
  | [ _; _; _; w ] ->
    let* weight = coordinate ~path w in
    let* v = coordinates ~path words in
    if Scc_exact.Rat.equal weight Scc_exact.Rat.one then
      Ok { state with vertices = v :: state.vertices; count = state.count + 1 }
    else error ~path w "the weight of a vertex must be 1"
  | _ -> error ~path keyword "expected the three coordinates of a vertex on this line"

let note state w = if Option.is_some state.odd then state else { state with odd = Some w }

(* What a corner names beside its vertex: a place in a picture and a normal, neither of which moves anything. *)
let beside ~path state w =
  let one state (what, count) text =
    if String.equal text "" then Ok state
    else
      let* i = integer ~path ~what:"an index" { w with text } in
      let known = match what with `Texture -> state.textures | `Normal -> state.normals in
      if i = 0 || -i > known then Ok (note state w)
      else if i > count then Ok { state with named = (w, i, what) :: state.named }
      else Ok state
  in
  match List.tl (String.split_on_char '/' w.text) with
  | [] -> Ok state
  | [ texture ] -> one state (`Texture, state.textures) texture
  | [ texture; normal ] ->
    let* state = one state (`Texture, state.textures) texture in
    one state (`Normal, state.normals) normal
  | _ -> error ~path w "a corner has at most three indices: %s" (quote w.text)

(* A normal, a place in a picture, or a parameter of a curve. *)
let numbers_statement state keyword words =
  let n = List.length words in
  let right = match keyword.text with "vn" -> n = 3 | _ -> n >= 1 && n <= 3 in
  let state = if right && List.for_all is_number words then state else note state keyword in
  match keyword.text with
  | "vn" -> { state with normals = state.normals + 1 }
  | "vt" -> { state with textures = state.textures + 1 }
  | _ -> state

let corner ~path state w =
  let index =
    match String.index_opt w.text '/' with
    | None -> w
    | Some i -> { w with text = String.sub w.text 0 i }
  in
  let* i = integer ~path ~what:"the index of a vertex" index in
  if i > 0 then Ok (index, i - 1)
  else if i = 0 then error ~path index "a face names vertex 0, but the vertices of an OBJ file count from 1"
  else if -i > state.count then
    error ~path index "a face names vertex %d, but only %d vertices come before" i state.count
  else Ok (index, state.count + i)

let face_statement ~path keyword state words =
  let* corners = Result.all (corner ~path state) words in
  let* state = List.fold_left (fun state w -> Result.bind state (fun s -> beside ~path s w)) (Ok state) words in
  match corners with
  | _ :: _ :: _ :: _ -> 
    let label = match state.groups with Some _ as g -> g | None -> state.objects in
    Ok { state with faces = (label, Array.of_list corners) :: state.faces }
  | _ -> error ~path keyword "a face needs at least three corners, not %d" (List.length corners)

(* A face may be in several groups: it is called after the first. *)
let first = function [] -> None | (w : word) :: _ -> Some w.text

let statement ~path state = function
  | [] -> Bug.fail __POS__ "a line without words"
  | keyword :: words -> (
      match (keyword.text, List.assoc_opt keyword.text keywords) with
      | "v", _ -> vertex_statement ~path keyword state words
      | "g", _ -> Ok { state with groups = first words }
      | "o", _ -> Ok { state with objects = first words; groups = None }
      | _, Some Read -> face_statement ~path keyword state words
      | ("vn" | "vt" | "vp"), _ -> Ok (numbers_statement state keyword words)
      | _, Some Still -> Ok state
      | _, Some Left_out ->
        Ok (if Option.is_some state.left_out then state else { state with left_out = Some keyword })
      | _, Some (Refused why) -> error ~path keyword "%s" why
      | k, None -> error ~path keyword "unknown OBJ statement %s" (quote k))

let resolve ~path count (label, corners) =
  let check () (w, i) =
    if i < count then Ok ()
    else error ~path w "a face names vertex %d, but there are only %d vertices" (i + 1) count
  in
  let rec all i =
    if i >= Array.length corners then Ok (label, Array.map snd corners)
    else
      let* () = check () corners.(i) in
      all (i + 1)
  in
  all 0

let read ~path text =
  let rec go state position =
    match next_line ~continued:true text position with
    | None -> Ok state
    | Some (words, next) -> (
        match statement ~path state words with
        | Ok state -> go state next
        | Error _ as e -> e)
  in
  let start =
    {
      vertices = []; count = 0; left_out = None; odd = None; textures = 0; normals = 0; named = [];
      objects = None; groups = None; faces = [];
    }
  in
  let* state = go start 0 in
  if state.count = 0 then error_at ~path 0 "the file has no vertices"
  else
    let* faces = Result.all (resolve ~path state.count) (List.rev state.faces) in
    let warning w ?hint what =
      let span = Span.make ~file:path ~start:w.start ~stop:(w.start + String.length w.text) in
      Diag.warning Code.mesh_left_out span ?hint "%s" what
    in
    let hint = "nothing has to be done if the faces alone are meant" in
    let lines w = warning w ~hint "lines and points are left out" in
    let absent (_, i, what) = i > match what with `Texture -> state.textures | `Normal -> state.normals in
    let odd =
      match (state.odd, List.find_opt absent (List.rev state.named)) with
      | None, Some (w, _, _) -> Some w
      | found, _ -> found
    in
    let beside w =
      warning w "normals and places in pictures that are none, or that are not there, here the first, are left out"
    in
    let found = Option.to_list (Option.map lines state.left_out) @ Option.to_list (Option.map beside odd) in
    Ok (labelled state.vertices (List.rev faces), found)
