open Scc_base
open Scc_exact
open Text

type scalar = Signed of int | Unsigned of int | Real of int  (* with their bytes *)
type property = Scalar of string * scalar | List of string * scalar * scalar
type element = { name : string; count : int; properties : property list; at : word }
type encoding = Ascii | Binary of { big_endian : bool }

(* {1 Header} *)

let scalar ~path w =
  match w.text with
  | "char" | "int8" -> Ok (Signed 1)
  | "uchar" | "uint8" -> Ok (Unsigned 1)
  | "short" | "int16" -> Ok (Signed 2)
  | "ushort" | "uint16" -> Ok (Unsigned 2)
  | "int" | "int32" -> Ok (Signed 4)
  | "uint" | "uint32" -> Ok (Unsigned 4)
  | "float" | "float32" -> Ok (Real 4)
  | "double" | "float64" -> Ok (Real 8)
  | other -> error ~path w "unknown type %s" (quote other)

let encoding ~path w =
  match w.text with
  | "ascii" -> Ok Ascii
  | "binary_little_endian" -> Ok (Binary { big_endian = false })
  | "binary_big_endian" -> Ok (Binary { big_endian = true })
  | other -> error ~path w "unknown PLY format %s" (quote other)

let name_of = function Scalar (name, _) | List (name, _, _) -> name

(* The list of corners has two names. *)
let same_name p q =
  let plain p = match name_of p with "vertex_index" -> "vertex_indices" | name -> name in
  String.equal (plain p) (plain q)

(* One line of the header, after the first; elements and their properties are in reverse order. *)
let header_line ~path (format, elements) line =
  let property w p =
    match elements with
    | [] -> error ~path w "a property before the first element"
    | e :: _ when List.exists (same_name p) e.properties ->
      error ~path w "the element %s has the property %s twice" (quote e.name) (quote (name_of p))
    | e :: rest -> Ok (format, { e with properties = p :: e.properties } :: rest)
  in
  match line with
  | { text = "comment" | "obj_info"; _ } :: _ -> Ok (format, elements)
  | { text = "format"; _ } as w :: _ when Option.is_some format -> error ~path w "the line `format` is there twice"
  | [ { text = "format"; _ }; w; version ] ->
    let* e = encoding ~path w in
    if String.equal version.text "1.0" then Ok (Some e, elements)
    else error ~path version "only version 1.0 of PLY is read, not %s" (quote version.text)
  | [ { text = "element"; _ }; name; _ ] when List.exists (fun e -> String.equal e.name name.text) elements ->
    error ~path name "the element %s is there twice" (quote name.text)
  | [ { text = "element"; _ }; name; n ] ->
    let* count = integer ~path ~what:"the number of elements" n in
    if count < 0 then error ~path n "the number of elements must not be negative"
    else Ok (format, { name = name.text; count; properties = []; at = n } :: elements)
  | [ { text = "property"; _ } as w; { text = "list"; _ }; count; item; name ] ->
    let* count = scalar ~path count in
    let* item = scalar ~path item in
    property w (List (name.text, count, item))
  | [ ({ text = "property"; _ } as w); kind; name ] ->
    let* kind = scalar ~path kind in
    property w (Scalar (name.text, kind))
  | w :: _ -> error ~path w "not a line of a PLY header: %s" (quote w.text)
  | [] -> Bug.fail __POS__ "a line without words"

(* Where lines end with a carriage return alone, a line feed after the last one is the first byte of the data. *)
let after_header text next =
  let alone =
    match String.index_opt text '\r' with
    | None -> false
    | Some i -> not (String.contains (String.sub text 0 (min (String.length text) (i + 2))) '\n')
  in
  if alone && next >= 2 && text.[next - 1] = '\n' && text.[next - 2] = '\r' then next - 1 else next

let header ~path text =
  let rec go acc last position =
    match next_line text position with
    | None -> error ~path last "the file ends before `end_header`"
    | Some ([ { text = "end_header"; _ } ], next) -> Ok (acc, last, after_header text next)
    | Some (line, next) -> (
        match header_line ~path acc line with
        | Ok acc -> go acc (List.hd line) next
        | Error _ as e -> e)
  in
  match next_line text 0 with
  | Some ([ ({ text = "ply"; _ } as w) ], next) -> (
      let* (format, elements), last, position = go (None, []) w next in
      let in_order e = { e with properties = List.rev e.properties } in
      match format with
      | Some format -> Ok (format, List.rev_map in_order elements, position)
      | None -> error ~path last "the header has no `format` line")
  | Some (w :: _, _) -> error ~path w "expected `ply`, found %s" (quote w.text)
  | Some ([], _) -> Bug.fail __POS__ "a line without words"
  | None -> error_at ~path 0 "the file is empty: expected `ply`"

(* {1 Data} *)

(* Where values come from. [start] begins an instance of an element and [finish] ends it; [real] and [integer]
   give the next value, and [skip] leaves it out; [place] is that of the value read last. *)
type source = {
  start : element -> int -> (unit, Diag.t) result;
  real : scalar -> (Rat.t, Diag.t) result;
  integer : scalar -> (int, Diag.t) result;
  skip : scalar -> (unit, Diag.t) result;
  finish : unit -> (unit, Diag.t) result;
  place : unit -> word;
  rest : unit -> (Diag.t list, Diag.t) result;  (* what follows the last element *)
}

let promise ~path e k =
  error ~path e.at "the header promises %d of `%s`, but the file has only %d" e.count e.name k

(* Values at the end of the lines of faces, after those that the header declares, are left out with a warning. In
   lines of other elements they may be coordinates. *)
(* The values of an integer type. *)
let range = function
  | Signed n -> (-(1 lsl ((8 * n) - 1)), (1 lsl ((8 * n) - 1)) - 1)
  | Unsigned n -> (0, (1 lsl (8 * n)) - 1)
  | Real _ -> (min_int, max_int)

let fits kind i =
  let least, most = range kind in
  least <= i && i <= most

let whole ~path kind w =
  let digits = String.for_all (function '0' .. '9' | '+' | '-' -> true | _ -> false) w.text in
  match if digits then int_of_string_opt w.text else None with
  | Some i when fits kind i -> Ok i
  | Some _ ->
    let least, most = range kind in
    error ~path w "%s is beyond the type of its property, which goes from %d to %d" (quote w.text) least most
  | None -> error ~path w "expected an integer, found %s" (quote w.text)

let left_out_at ~path (w : word) what =
  Diag.warning Code.mesh_left_out
    (Span.make ~file:path ~start:w.start ~stop:(w.start + String.length w.text))
    "%s" what

let ascii ~path text position =
  let position = ref position and line = ref [] and last = ref { text = ""; start = 0 } in
  let of_face = ref false and beyond = ref None and odd = ref None in
  let start e k =
    match next_line text !position with
    | None -> promise ~path e k
    | Some (words, next) ->
      of_face := String.equal e.name "face";
      line := words;
      position := next;
      Ok ()
  in
  let word () =
    match !line with
    | [] -> error ~path !last "the line ends before all values of the element are there"
    | w :: rest ->
      line := rest;
      last := w;
      Ok w
  in
  let real = function
    | Real _ -> Result.bind (word ()) (coordinate ~path)
    | (Signed _ | Unsigned _) as kind -> Result.map Rat.of_int (Result.bind (word ()) (whole ~path kind))
  in
  let integer = function
    | Real _ -> error ~path !last "expected a property of an integer type"
    | (Signed _ | Unsigned _) as kind -> Result.bind (word ()) (whole ~path kind)
  in
  let finish () =
    match !line with
    | [] -> Ok ()
    | w :: _ when !of_face ->
      if Option.is_none !beyond then beyond := Some w;
      Ok ()
    | w :: _ -> error ~path w "expected the end of the line after the values of the element"
  in
  let warnings () =
    let one found what = Option.to_list (Option.map (fun w -> left_out_at ~path w what) found) in
    one !beyond "values of faces after those that the header declares, here the first, are left out"
    @ one !odd "values that are not of the types of their properties, here the first, are left out"
  in
  (* What is not read changes nothing. *)
  let skip kind =
    let note w =
      let fine =
        match kind with
        | Real _ -> is_number w
        | Signed _ | Unsigned _ -> Result.is_ok (whole ~path kind w)
      in
      if Option.is_none !odd && not fine then odd := Some w
    in
    Result.map note (word ())
  in
  let rest () =
    match next_line text !position with
    | Some (w :: _, _) -> error ~path w "expected the end of the file after the elements that the header promises"
    | Some ([], _) | None -> Ok (warnings ())
  in
  { start; real; integer; skip; finish; place = (fun () -> !last); rest }

let binary ~path ~big_endian text position =
  let position = ref position and last = ref position and element = ref None in
  let take width =
    if !position + width > String.length text then
      match !element with
      | Some (e, k) -> promise ~path e k
      | None -> Bug.fail __POS__ "a value outside of any element"
    else begin
      last := !position;
      position := !position + width;
      Ok !last
    end
  in
  let integer = function
    | Real _ -> error_at ~path !last "expected a property of an integer type"
    | Signed n -> Result.map (fun at -> Bytes_of.signed ~big_endian text at n) (take n)
    | Unsigned n -> Result.map (fun at -> Bytes_of.unsigned ~big_endian text at n) (take n)
  in
  let real = function
    | Real n -> Result.bind (take n) (fun at -> Bytes_of.real ~path ~big_endian text at n)
    | (Signed _ | Unsigned _) as kind -> Result.map Rat.of_int (integer kind)
  in
  let start e k =
    element := Some (e, k);
    Ok ()
  in
  let skip (Signed n | Unsigned n | Real n) = Result.map ignore (take n) in
  let place () = { text = ""; start = !last } in
  let rest () =
    let n = String.length text - !position in
    let span = Span.make ~file:path ~start:!position ~stop:!position in
    let warning () =
      Diag.warning Code.mesh_left_out span "%s after the last element that the header promises are left out"
        (Plural.count n "byte" "bytes")
    in
    Ok (if n > 0 then [ warning () ] else [])
  in
  { start; real; integer; skip; finish = Result.ok; place; rest }

(* {1 Elements} *)

let rec repeat n f acc =
  if n = 0 then Ok acc
  else
    match f acc with
    | Ok acc -> repeat (n - 1) f acc
    | Error _ as e -> e

let list_length ~path source kind =
  let* n = source.integer kind in
  if n < 0 then error ~path (source.place ()) "a list of %d entries" n else Ok n

let skip ~path source = function
  | Scalar (_, kind) -> source.skip kind
  | List (_, count, item) ->
    let* n = list_length ~path source count in
    repeat n (fun () -> source.skip item) ()

(* [total] instances, each by [one]; elements without properties take no room and are not gone through. *)
let instances source e one acc =
  let rec go k acc =
    if k = e.count then Ok acc
    else
      let step =
        let* () = source.start e k in
        let* acc = one acc in
        let* () = source.finish () in
        Ok acc
      in
      match step with
      | Ok acc -> go (k + 1) acc
      | Error _ as e -> e
  in
  match e.properties with
  | [] -> Ok acc
  | _ :: _ -> go 0 acc

let over_properties f e start =
  List.fold_left (fun acc p -> Result.bind acc (fun acc -> f acc p)) (Ok start) e.properties

let vertex ~path source e acc =
  let property (v : Vec.t) = function
    | Scalar ("x", kind) -> Result.map (fun x -> { v with x }) (source.real kind)
    | Scalar ("y", kind) -> Result.map (fun y -> { v with y }) (source.real kind)
    | Scalar ("z", kind) -> Result.map (fun z -> { v with z }) (source.real kind)
    | other -> Result.map (fun () -> v) (skip ~path source other)
  in
  Result.map (fun v -> v :: acc) (over_properties property e Vec.zero)

let corner ~path ~count source kind acc =
  let* i = source.integer kind in
  if i >= 0 && i < count then Ok (i :: acc)
  else error ~path (source.place ()) "a face names vertex %d, but there are %d vertices" i count

let face ~path ~count source e acc =
  let property found = function
    | List (("vertex_indices" | "vertex_index"), length, item) ->
      let* n = list_length ~path source length in
      if n < 3 then error ~path (source.place ()) "a face needs at least three corners, not %d" n
      else Result.map List.rev (repeat n (corner ~path ~count source item) [])
    | other -> Result.map (fun () -> found) (skip ~path source other)
  in
  Result.map (fun corners -> Array.of_list corners :: acc) (over_properties property e [])

(* The triangles of strips, which -1 ends; those without an area are left out. *)
let triangles_of corners faces =
  let add faces (a : int) b c = if a = b || b = c || c = a then faces else [| a; b; c |] :: faces in
  let rec go faces even = function
    | a :: (b :: c :: _ as rest) when a >= 0 && b >= 0 && c >= 0 ->
      go (if even then add faces a b c else add faces b a c) (not even) rest
    | a :: rest -> go faces (if a < 0 then true else even) rest
    | [] -> faces
  in
  go faces true corners

let strips ~path ~count source e faces =
  let corner kind acc =
    let* i = source.integer kind in
    if i >= -1 && i < count then Ok (i :: acc)
    else error ~path (source.place ()) "a strip names vertex %d, but there are %d vertices" i count
  in
  let property faces = function
    | List (("vertex_indices" | "vertex_index"), length, item) ->
      let* n = list_length ~path source length in
      let* corners = repeat n (corner item) [] in
      Ok (triangles_of (List.rev corners) faces)
    | other -> Result.map (fun () -> faces) (skip ~path source other)
  in
  over_properties property e faces

let has_scalar e name =
  List.exists (function Scalar (n, _) -> String.equal n name | List _ -> false) e.properties

let has_indices e =
  let is_indices = function
    | List (("vertex_indices" | "vertex_index"), _, _) -> true
    | List _ | Scalar _ -> false
  in
  List.exists is_indices e.properties

let element ~path ~count source (vertices, faces) e =
  match e.name with
  | "vertex" ->
    if List.for_all (has_scalar e) [ "x"; "y"; "z" ] then
      Result.map (fun vertices -> (vertices, faces)) (instances source e (vertex ~path source e) vertices)
    else error ~path e.at "the element `vertex` lacks one of the properties x, y and z"
  | "face" ->
    if has_indices e then
      Result.map (fun faces -> (vertices, faces)) (instances source e (face ~path ~count source e) faces)
    else error ~path e.at "the element `face` lacks the list `vertex_indices`"
  | "tristrips" ->
    if has_indices e then
      Result.map (fun faces -> (vertices, faces)) (instances source e (strips ~path ~count source e) faces)
    else error ~path e.at "the element `tristrips` lacks the list `vertex_indices`"
  | "range_grid" -> error ~path e.at "grids of a scanner are not read: make triangles of them first"
  | _ ->
    let skip_all () = over_properties (fun () p -> skip ~path source p) e () in
    Result.map (fun () -> (vertices, faces)) (instances source e skip_all ())

(* Cameras, materials and notes make no shapes. *)
let still = [ "vertex"; "face"; "tristrips"; "material"; "camera"; "user" ]

let left_out ~path e =
  if e.count = 0 || List.mem e.name still then None
  else
    Some
      (Diag.warning Code.mesh_left_out
         (Span.make ~file:path ~start:e.at.start ~stop:(e.at.start + String.length e.at.text))
         ~hint:"nothing has to be done if they make no faces" "the %d of the element %s are left out" e.count
         (quote e.name))

let read ~path text =
  let* format, elements, position = header ~path text in
  let source =
    match format with
    | Ascii -> ascii ~path text position
    | Binary { big_endian } -> binary ~path ~big_endian text position
  in
  let vertices e = if String.equal e.name "vertex" then e.count else 0 in
  let count = List.fold_left (fun n e -> n + vertices e) 0 elements in
  let* vertices, faces =
    List.fold_left
      (fun acc e -> Result.bind acc (fun acc -> element ~path ~count source acc e))
      (Ok ([], []))
      elements
  in
  let* trailing = source.rest () in
  Ok (ifs vertices faces, List.filter_map (left_out ~path) elements @ trailing)
