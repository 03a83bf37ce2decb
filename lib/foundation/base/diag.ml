type severity = Error | Warning

type t = {
  code : string;
  severity : severity;
  span : Span.t;
  message : string;
  notes : (Span.t * string) list;
  hint : string option;
}

let make severity ?(notes = []) ?hint (code : Code.t) span fmt =
  Printf.ksprintf
    (fun message -> { code = (code :> string); severity; span; message; notes; hint })
    fmt

let error ?notes ?hint code span fmt = make Error ?notes ?hint code span fmt
let warning ?notes ?hint code span fmt = make Warning ?notes ?hint code span fmt
let is_error d = match d.severity with Error -> true | Warning -> false

let compare a b =
  let open Prelude in
  String.compare a.span.Span.file b.span.Span.file <?> fun () ->
    Int.compare a.span.Span.start b.span.Span.start <?> fun () ->
      Stdlib.compare (a.severity : severity) b.severity <?> fun () ->
        String.compare a.code b.code <?> fun () -> String.compare a.message b.message

(* Edit distance with adjacent transpositions, times 100; names are short. A letter instead of another one costs
   more than one that is missing by a hundredth: of two candidates at the same distance, that is nearer which has
   more of the letters. *)
let distance a b =
  let n = String.length a and m = String.length b in
  let d = Array.make_matrix (n + 1) (m + 1) 0 in
  for i = 0 to n do d.(i).(0) <- 100 * i done;
  for j = 0 to m do d.(0).(j) <- 100 * j done;
  for i = 1 to n do
    for j = 1 to m do
      let cost = if a.[i - 1] = b.[j - 1] then 0 else 101 in
      let best =
        min (d.(i - 1).(j) + 100) (min (d.(i).(j - 1) + 100) (d.(i - 1).(j - 1) + cost))
      in
      d.(i).(j) <-
        (if i > 1 && j > 1 && a.[i - 1] = b.[j - 2] && a.[i - 2] = b.[j - 1] then
           min best (d.(i - 2).(j - 2) + 100)
         else best)
    done
  done;
  d.(n).(m)

let nearest name candidates =
  let limit = max 1 (String.length name / 3) in
  let better best c =
    if String.length c > 64 || String.length name > 64 then best
    else
      let k = distance name c in
      match best with
      | Some (k', _) when k' <= k -> best
      | _ when k / 100 <= limit && k > 0 -> Some (k, c)
      | _ -> best
  in
  List.fold_left better None candidates
  |> Option.map snd

let suggest name candidates = Option.map (Printf.sprintf "did you mean `%s`?") (nearest name candidates)

let suggestions hint =
  let rec names found = function
    | name :: " or " :: rest -> names (name :: found) rest
    | name :: after :: _ when String.starts_with ~prefix:"?" after -> List.rev (name :: found)
    | _ -> []
  in
  match String.split_on_char '`' hint with "did you mean " :: rest -> names [] rest | _ -> []

let code_points s =
  let n = ref 0 in
  String.iter (fun c -> if Char.code c land 0xC0 <> 0x80 then incr n) s;
  !n

(* A long line is shown in part: a window of [width] code points about the span. *)
let width = 120

let utf8_sub s first count =
  let b = Buffer.create count in
  let k = ref (-1) in
  String.iter
    (fun c ->
       if Char.code c land 0xC0 <> 0x80 then incr k;
       if !k >= first && !k < first + count then Buffer.add_char b c)
    s;
  Buffer.contents b

let excerpt source (span : Span.t) =
  let l1, c1 = Source.position source span.start in
  let l2, c2 = Source.position source span.stop in
  let text = Source.line source l1 in
  (* a text must not control the terminal of who reads about it *)
  let text = String.map (fun c -> if c < ' ' || c = '\127' then ' ' else c) text in
  let column c = 1 + code_points (Visible.text (utf8_sub text 0 (c - 1))) in
  let c1 = column c1 and c2 = column c2 and text = Visible.text text in
  let length = code_points text in
  let stop = if l2 > l1 then length + 1 else max (c1 + 1) c2 in
  let first = if length <= width then 0 else max 0 (min (c1 - 1 - (width / 3)) (length - width)) in
  let shown = utf8_sub text first width in
  let carets = max 1 (min (stop - c1) (width - (c1 - 1 - first))) in
  let number = string_of_int l1 in
  let gutter = String.make (String.length number) ' ' in
  Printf.sprintf " %s |\n %s | %s\n %s | %s%s\n" gutter number shown gutter
    (String.make (max 0 (c1 - 1 - first)) ' ')
    (String.make carets '^')

let of_file file d = if Span.is_none d.span then { d with span = Span.whole file } else d

let place source (span : Span.t) =
  match source with
  | Some s ->
    let l, c = Source.position s span.start in
    Printf.sprintf "%s:%d:%d: " span.file l c
  | None -> if Span.is_none span then "" else span.file ^ ": "

let render ~source d =
  let b = Buffer.create 256 in
  let find (span : Span.t) = if Span.is_none span || span.whole then None else source span.file in
  let line text = Buffer.add_string b (Visible.line text ^ "\n") in
  let shown span = Option.iter (fun s -> Buffer.add_string b (excerpt s span)) (find span) in
  let severity = match d.severity with Error -> "error" | Warning -> "warning" in
  line (Printf.sprintf "%s%s[%s]: %s" (place (find d.span) d.span) severity d.code d.message);
  shown d.span;
  List.iter
    (fun (span, note) ->
       line (Printf.sprintf "%snote: %s" (place (find span) span) note);
       shown span)
    d.notes;
  Option.iter (fun h -> line ("  hint: " ^ h)) d.hint;
  Buffer.contents b
