open Scc_base
open Scc_exact
open Text

let add soup a b c =
  let a = Soup.number soup a in
  let b = Soup.number soup b in
  let c = Soup.number soup c in
  Soup.add soup a b c

(* {1 ASCII} *)

let keyword w = String.lowercase_ascii w.text

(* One line whose first words are these: its first word (for errors), the words after them, the position. *)
let expect ~path ~last text position words =
  match next_line text position with
  | None -> error ~path last "the file ends before `%s`" (String.concat " " words)
  | Some ([], _) -> Bug.fail __POS__ "a line without words"
  | Some ((first :: _ as line), next) ->
    let rec strip line wanted =
      match (line, wanted) with
      | rest, [] -> Ok (first, rest, next)
      | w :: rest, k :: wanted when String.equal (keyword w) k -> strip rest wanted
      | w :: _, _ -> error ~path w "expected `%s`, found %s" (String.concat " " words) (quote w.text)
      | [], _ -> error ~path first "expected `%s` on this line" (String.concat " " words)
    in
    strip line words

let corner ~path ~last text position =
  let* last, rest, position = expect ~path ~last text position [ "vertex" ] in
  match rest with
  | [ _; _; _ ] ->
    let* v = coordinates ~path rest in
    Ok (v, last, position)
  | _ -> error ~path last "expected the three coordinates of a vertex on this line"

let facet ~path ~last text position =
  let* last, _, position = expect ~path ~last text position [ "outer"; "loop" ] in
  let* a, last, position = corner ~path ~last text position in
  let* b, last, position = corner ~path ~last text position in
  let* c, last, position = corner ~path ~last text position in
  let* last, _, position = expect ~path ~last text position [ "endloop" ] in
  let* last, _, position = expect ~path ~last text position [ "endfacet" ] in
  Ok ((a, b, c), last, position)

(* A normal is three numbers, or left out. The corners say what it is. *)
let is_normal = function
  | [] -> true
  | w :: numbers ->
    String.equal (keyword w) "normal" && List.compare_length_with numbers 3 = 0 && List.for_all is_number numbers

(* If all is on one line, each keyword begins one in place of the blank before it. *)
let in_lines text =
  let starts = [ "facet"; "outer"; "vertex"; "endloop"; "endfacet"; "endsolid"; "solid" ] in
  let is_facet w = String.equal (keyword w) "facet" in
  match next_line text 0 with
  | Some (_ :: rest, next) when Option.is_none (next_line text next) && List.exists is_facet rest ->
    let lines = Bytes.of_string text in
    let begin_line w = if List.mem (keyword w) starts then Bytes.set lines (w.start - 1) '\n' in
    List.iter begin_line rest;
    Bytes.unsafe_to_string lines
  | _ -> text

let ascii ~path text soup =
  let text = in_lines text in
  let odd = ref None in
  let rec between last position =
    match next_line text position with
    | None -> (
        match last with
        | None -> error_at ~path 0 "the file is empty: expected `solid`"
        | Some _ -> Ok ())
    | Some (w :: _, next) when String.equal (keyword w) "solid" -> inside w next
    | Some (w :: _, _) -> error ~path w "expected `solid`, found %s" (quote w.text)
    | Some ([], _) -> Bug.fail __POS__ "a line without words"
  and inside last position =
    match next_line text position with
    | None -> error ~path last "the file ends before `endsolid`"
    | Some (w :: _, next) when String.equal (keyword w) "endsolid" -> between (Some w) next
    | Some (w :: normal, next) when String.equal (keyword w) "facet" -> (
        if Option.is_none !odd && not (is_normal normal) then odd := Some w;
        match facet ~path ~last:w text next with
        | Ok ((a, b, c), last, next) ->
          add soup a b c;
          inside last next
        | Error _ as e -> e)
    | Some (w :: _, _) -> error ~path w "expected `facet` or `endsolid`, found %s" (quote w.text)
    | Some ([], _) -> Bug.fail __POS__ "a line without words"
  in
  let warning (w : word) =
    Diag.warning Code.mesh_left_out
      (Span.make ~file:path ~start:w.start ~stop:(w.start + String.length w.text))
      "normals that are not three numbers, here the first, are left out"
  in
  Result.map (fun () -> Option.to_list (Option.map warning !odd)) (between None 0)

(* {1 Binary: 80 bytes of comment, the number of triangles, 50 bytes for each} *)

let binary ~path text count ~next soup =
  let point offset =
    let real k = Bytes_of.real ~path ~big_endian:false text (offset + (4 * k)) 4 in
    let* x = real 0 in
    let* y = real 1 in
    let* z = real 2 in
    Ok (Vec.make x y z)
  in
  let triangle offset =
    let* a = point (offset + 12) in
    let* b = point (offset + 24) in
    let* c = point (offset + 36) in
    add soup a b c;
    Ok ()
  in
  let rec go k offset =
    if k = count then Ok ()
    else
      match triangle offset with
      | Ok () -> go (k + 1) (next offset)
      | Error _ as e -> e
  in
  go 0 84

(* Where the triangles end, if each is followed by as many bytes as its last number says: by what some programs
   write about it. *)
let end_with_data text count =
  let n = String.length text in
  let rec go k offset =
    if k = count then Some offset
    else if offset + 50 > n then None
    else go (k + 1) (offset + 50 + Bytes_of.unsigned ~big_endian:false text (offset + 48) 2)
  in
  go 0 84

let trailing ~path ~stop n =
  let span = Span.make ~file:path ~start:stop ~stop in
  Diag.warning Code.mesh_left_out span "%s after the last triangle that the header promises are left out"
    (Plural.count (n - stop) "byte" "bytes")

let read_binary ~path text count soup =
  let n = String.length text in
  let plain = 84 + (50 * count) in
  if n = plain then Result.map (fun () -> []) (binary ~path text count ~next:(fun o -> o + 50) soup)
  else
    match end_with_data text count with
    | Some stop when stop = n && count > 0 ->
      let next o = o + 50 + Bytes_of.unsigned ~big_endian:false text (o + 48) 2 in
      Result.map (fun () -> []) (binary ~path text count ~next soup)
    | _ when n > plain && count > 0 ->
      let* () = binary ~path text count ~next:(fun o -> o + 50) soup in
      Ok [ trailing ~path ~stop:plain n ]
    | _ ->
      error_at ~path 0 "the header promises %d triangles, which take %d bytes, but the file has %d" count plain n

let read ~path text =
  let n = String.length text in
  let soup = Soup.create () in
  let promised = if n >= 84 then Bytes_of.unsigned ~big_endian:false text 80 4 else 0 in
  (* Some writers begin binary files with `solid` too; text has no zero bytes. *)
  let starts_solid =
    match next_line (String.sub text 0 (min n 80)) 0 with
    | Some (w :: _, _) -> String.equal (keyword w) "solid"
    | Some ([], _) | None -> false
  in
  let is_text = not (String.contains text '\000') in
  let* warnings =
    if n >= 84 && n = 84 + (50 * promised) then read_binary ~path text promised soup
    else if is_text && (starts_solid || String.equal (String.trim text) "") then
      ascii ~path text soup
    else if n < 84 then error_at ~path 0 "expected `solid`, or the 84 bytes of a binary header"
    else read_binary ~path text promised soup
  in
  Ok (Soup.solid soup, warnings)
