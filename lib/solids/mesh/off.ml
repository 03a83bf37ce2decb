open Scc_base
open Text

(* What the header promises: never used to reserve memory. *)
type counts = { vertices : int; faces : int; at : Text.word }

(* What vertices have beside their places, by the letters before OFF in any order. *)
type more = { colours : bool; normals : bool; texture : bool }

let keyword word =
  (* In small letters [n] is a number of dimensions, and so no other keyword may have them. *)
  let word = if String.equal (String.uppercase_ascii word) "OFF" then "OFF" else word in
  let n = String.length word in
  let rec go more i =
    let rest = String.sub word i (n - i) in
    let after k more = go more (i + k) in
    if String.equal rest "OFF" then Some more
    else if String.starts_with ~prefix:"ST" rest && not more.texture then after 2 { more with texture = true }
    else if String.starts_with ~prefix:"C" rest && not more.colours then after 1 { more with colours = true }
    else if String.starts_with ~prefix:"N" rest && not more.normals then after 1 { more with normals = true }
    else None
  in
  go { colours = false; normals = false; texture = false } 0

let is_keyword word = Option.is_some (keyword word)

(* [4OFF], [nOFF], [C4nOFF], …: points of other than three coordinates. *)
let of_dimensions word =
  let n = String.length word in
  n > 3
  && String.equal (String.sub word (n - 3) 3) "OFF"
  && (String.contains word '4' || String.contains word 'n')
  && is_keyword (String.concat "" (List.concat_map (String.split_on_char 'n') (String.split_on_char '4' word)))

let first_word text =
  match next_line (String.sub text 0 (min 80 (String.length text))) 0 with
  | Some (w :: _, _) -> w.text
  | Some ([], _) | None -> ""

(* Some programs write the first count at once after the keyword. *)
let begins text =
  let word = first_word text in
  let n = String.length word in
  let is_digit i = word.[i] >= '0' && word.[i] <= '9' in
  let stop = Option.value (List.find_opt is_digit (List.init n Fun.id)) ~default:n in
  is_keyword (String.sub word 0 stop) || of_dimensions word

(* The least and the greatest number of words after the three coordinates. *)
let spare more =
  let normals = if more.normals then 3 else 0 and texture = if more.texture then 2 else 0 in
  let colours = if more.colours then (3, 4) else (0, 0) in
  (normals + texture + fst colours, normals + texture + snd colours)

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
  | Some ({ text; _ } :: _, _) when of_dimensions text ->
    Error
      (Diag.error Code.mesh_format (Span.of_file path)
         "OFF files of other than three dimensions are not supported")
  | Some (_ :: { text = "BINARY"; _ } :: _, _) ->
    Error
      (Diag.error Code.mesh_format (Span.of_file path)
         "binary OFF files are not supported" ~hint:"convert the file to ASCII OFF")
  | Some ([], _) -> Bug.fail __POS__ "a line without words"
  | Some (w :: rest, next) when is_keyword w.text -> (
      let spare = Option.fold ~none:(0, 0) ~some:spare (keyword w.text) in
      match (rest, next_line text next) with
      | _ :: _, _ ->
        let* c = counts ~path rest in
        Ok (c, spare, next)
      | [], Some (words, next) ->
        let* c = counts ~path words in
        Ok (c, spare, next)
      | [], None -> error ~path w "the file ends before the numbers of vertices, faces and edges")
  | Some (({ text; _ } :: _) as words, next) when String.for_all (fun c -> c >= '0' && c <= '9') text ->
    (* the keyword may be missing *)
    let* c = counts ~path words in
    Ok (c, (0, 0), next)
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

let vertex_line ~path ~spare:(least, most) = function
  | _ :: _ :: _ :: (extra :: _ as more) when most = 0 || List.length more > most ->
    if most = 0 then error ~path extra "a vertex of an OFF file has three coordinates (COFF, NOFF: and more)"
    else error ~path extra "expected at most %d numbers after the coordinates" most
  | _ :: _ :: _ :: (extra :: _ as more) when List.length more < least ->
    error ~path extra "expected %d numbers after the coordinates, or none" least
  | _ :: _ :: _ :: more as words ->
    let* _ = Result.all (coordinate ~path) more in
    coordinates ~path words
  | w :: _ -> error ~path w "expected the three coordinates of a vertex on this line"
  | [] -> Bug.fail __POS__ "a line without words"

(* An index into a map of colours, or three or four numbers. *)
let colour ~path = function
  | [] -> Ok ()
  | ([ _ ] | [ _; _; _ ] | [ _; _; _; _ ]) as words -> Result.map ignore (Result.all (coordinate ~path) words)
  | w :: _ -> error ~path w "expected the end of the line after the corners of a face, or a colour"

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
      let* () = colour ~path (List.filteri (fun i _ -> i >= corners) rest) in
      Ok (Array.of_list indices)

(* All on one line: its words tell where a point or a face ends, as long as nothing is beside them. *)
let on_one_line ~path words =
  let* c = counts ~path (List.filteri (fun i _ -> i < 3) words) in
  let last = List.fold_left (fun _ w -> w) c.at words in
  let rec vertices found k words =
    match words with
    | _ when k = 0 -> Ok (found, words)
    | x :: y :: z :: rest ->
      let* point = coordinates ~path [ x; y; z ] in
      vertices (point :: found) (k - 1) rest
    | _ -> error ~path last "the header promises %d vertices, but the file has only %d" c.vertices (c.vertices - k)
  in
  let rec split n taken rest =
    match rest with w :: rest when n > 0 -> split (n - 1) (w :: taken) rest | _ -> (List.rev taken, rest)
  in
  let rec faces found k words =
    match words with
    | [] when k = 0 -> Ok found
    | w :: _ when k = 0 -> error ~path w "expected the end of the file after the faces that the header promises"
    | w :: rest ->
      let* corners = integer ~path ~what:"the number of corners of a face" w in
      let own, rest = split corners [] rest in
      let* face = face_line ~path ~count:c.vertices (w :: own) in
      faces (face :: found) (k - 1) rest
    | [] -> error ~path last "the header promises %d faces, but the file has only %d" c.faces (c.faces - k)
  in
  let* points, rest = vertices [] c.vertices (snd (split 3 [] words)) in
  let* faces = faces [] c.faces rest in
  Ok (ifs points faces)

let read_lines ~path text =
  let* c, spare, position = header ~path text in
  let at = c.at in
  let* vertices, position =
    lines ~path ~what:"vertices" ~at text c.vertices position (vertex_line ~path ~spare)
  in
  let* faces, position =
    lines ~path ~what:"faces" ~at text c.faces position (face_line ~path ~count:c.vertices)
  in
  match next_line text position with
  | Some (w :: _, _) ->
    error ~path w "expected the end of the file after the %d vertices and %d faces that the header promises"
      c.vertices c.faces
  | Some ([], _) | None -> Ok (ifs vertices faces)

let read ~path text =
  match next_line text 0 with
  | Some ((w :: (_ :: _ :: _ :: _ :: _ as words)), next)
    when Option.equal Int.equal (Option.map (fun m -> snd (spare m)) (keyword w.text)) (Some 0)
      && Option.is_none (next_line text next) ->
    on_one_line ~path words
  | _ -> read_lines ~path text
