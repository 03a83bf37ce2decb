open Scc_base
open Text

(* What the header promises: never used to reserve memory. *)
type counts = { vertices : int; faces : int; at : Text.word }

let is_keyword w =
  match w with
  | "OFF" | "COFF" | "NOFF" | "CNOFF" | "STOFF" | "STCOFF" | "STNOFF" | "STCNOFF" -> true
  | _ -> false

(* Some programs write the first count at once after the keyword. *)
let unglued = function
  | ({ text; start } as w) :: rest -> (
      let digit i = text.[i] >= '0' && text.[i] <= '9' in
      match List.find_opt digit (List.init (min 8 (String.length text)) Fun.id) with
      | Some i when i > 0 && is_keyword (String.sub text 0 i) ->
        let count = { text = String.sub text i (String.length text - i); start = start + i } in
        { w with text = String.sub text 0 i } :: count :: rest
      | Some _ | None -> w :: rest)
  | [] -> []

let counts ~path = function
  | v :: f :: rest ->
    let* vertices = integer ~path ~what:"the number of vertices" v in
    let* faces = integer ~path ~what:"the number of faces" f in
    let* () =
      match rest with
      | [] | [ _ ] -> Ok ()
      | _ :: extra :: _ -> error ~path extra "expected the end of the line after the three counts"
    in
    let* _ =
      match rest with
      | [] -> Ok 0
      | e :: _ -> integer ~path ~what:"the number of edges" e
    in
    if vertices < 0 || faces < 0 then error ~path v "the counts must not be negative"
    else Ok { vertices; faces; at = v }
  | [ w ] -> error ~path w "expected the numbers of vertices, faces and edges on this line"
  | [] -> Bug.fail __POS__ "a line without words"

let header ~path text =
  match Option.map (fun (words, next) -> (unglued words, next)) (next_line text 0) with
  | None -> error_at ~path 0 "the file is empty: expected `OFF`"
  | Some ({ text = "4OFF" | "nOFF" | "4nOFF"; _ } :: _, _) ->
    Error
      (Diag.error Code.mesh_format (Span.of_file path)
         "OFF files of other than three dimensions are not supported")
  | Some (_ :: { text = "BINARY"; _ } :: _, _) ->
    Error
      (Diag.error Code.mesh_format (Span.of_file path)
         "binary OFF files are not supported" ~hint:"convert the file to ASCII OFF")
  | Some ([], _) -> Bug.fail __POS__ "a line without words"
  | Some (w :: rest, next) when is_keyword w.text -> (
      match (rest, next_line text next) with
      | _ :: _, _ ->
        let* c = counts ~path rest in
        Ok (c, not (String.equal w.text "OFF"), next)
      | [], Some (words, next) ->
        let* c = counts ~path words in
        Ok (c, not (String.equal w.text "OFF"), next)
      | [], None -> error ~path w "the file ends before the numbers of vertices, faces and edges")
  | Some (({ text; _ } :: _) as words, next) when String.for_all (fun c -> c >= '0' && c <= '9') text ->
    (* the keyword may be missing *)
    let* c = counts ~path words in
    Ok (c, false, next)
  | Some (w :: _, _) -> error ~path w "expected `OFF`, found %s" (quote w.text)

(* [total] lines, each through [read]. *)
let lines ~path ~what ~at text total position read =
  let rec go acc k position =
    if k = total then Ok (acc, position)
    else
      match next_line text position with
      | None -> error ~path at "the header promises %d %s, but the file has only %d" total what k
      | Some (words, next) -> (
          match read words with
          | Ok x -> go (x :: acc) (k + 1) next
          | Error _ as e -> e)
  in
  go [] 0 position

let vertex_line ~path ~coloured = function
  | _ :: _ :: _ :: extra :: _ when not coloured ->
    error ~path extra "a vertex of an OFF file has three coordinates (COFF, NOFF: and more)"
  | _ :: _ :: _ :: _ as words -> coordinates ~path words
  | w :: _ -> error ~path w "expected the three coordinates of a vertex on this line"
  | [] -> Bug.fail __POS__ "a line without words"

let face_line ~path ~count = function
  | [] -> Bug.fail __POS__ "a line without words"
  | k :: rest ->
    let* corners = integer ~path ~what:"the number of corners of a face" k in
    let given = List.length rest in
    if corners < 3 then error ~path k "a face needs at least three corners, not %d" corners
    else if given < corners then
      error ~path k "the face promises %d corners, but the line names only %d" corners given
    else
      let* indices = Result.all (vertex ~path ~count) (List.filteri (fun i _ -> i < corners) rest) in
      Ok (Array.of_list indices)

let read ~path text =
  let* c, coloured, position = header ~path text in
  let at = c.at in
  let* vertices, position =
    lines ~path ~what:"vertices" ~at text c.vertices position (vertex_line ~path ~coloured)
  in
  let* faces, position =
    lines ~path ~what:"faces" ~at text c.faces position (face_line ~path ~count:c.vertices)
  in
  match next_line text position with
  | Some (w :: _, _) ->
    error ~path w "expected the end of the file after the %d vertices and %d faces that the header promises"
      c.vertices c.faces
  | Some ([], _) | None -> Ok (ifs vertices faces)
