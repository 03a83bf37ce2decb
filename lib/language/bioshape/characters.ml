open Scc_base
open Scc_syntax

let none source at = { Embedded.source; text = ""; place = (fun _ -> at) }

(* What a reference stands for, by what is between `&` and `;`. *)
let meaning name =
  match name with
  | "lt" -> "<"
  | "gt" -> ">"
  | "amp" -> "&"
  | "quot" -> "\""
  | "apos" -> "'"
  | _ ->
    (* Xmlm has let it pass, but for numbers that are too large for it. *)
    let digits = String.sub name 1 (String.length name - 1) in
    let digits = if String.length digits > 0 && digits.[0] = 'x' then "0" ^ digits else "0u" ^ digits in
    (match int_of_string_opt digits with
     | Some n when Uchar.is_valid n ->
       let b = Buffer.create 4 in
       Buffer.add_utf_8_uchar b (Uchar.of_int n);
       Buffer.contents b
     | Some _ | None -> "\xEF\xBF\xBD")

(* Text with the place of each of its bytes. *)
type decoded = { bytes : Buffer.t; mutable places : int array }

let add d at s =
  let n = Buffer.length d.bytes and k = String.length s in
  if n + k > Array.length d.places then begin
    let longer = Array.make ((2 * (n + k)) + 16) 0 in
    Array.blit d.places 0 longer 0 n;
    d.places <- longer
  end;
  Array.fill d.places n k at;
  Buffer.add_string d.bytes s

let finished source d start stop first last =
  let text = Buffer.contents d.bytes in
  let text = String.sub text first (last - first) in
  let n = Buffer.length d.bytes in
  let place i =
    let i = first + i in
    if i < n then d.places.(i) else if n = 0 then start else stop
  in
  (* Where a text ends that something follows which stands for nothing: after its last character. *)
  { Embedded.source; text; place }

let plain c = c <> '&' && c <> '\r' && c <> '\n' && c <> '\t'

let attribute source start stop =
  let raw = Source.text source in
  let rec all_plain i = i >= stop || (plain raw.[i] && all_plain (i + 1)) in
  if all_plain start then
    { Embedded.source; text = String.sub raw start (stop - start); place = (fun i -> start + i) }
  else
    let d = { bytes = Buffer.create (stop - start); places = [||] } in
    let rec go i =
      if i < stop then
        match raw.[i] with
        | '&' ->
          let close = String.index_from raw i ';' in
          add d i (meaning (String.sub raw (i + 1) (close - i - 1)));
          go (close + 1)
        | '\r' when i + 1 < stop && raw.[i + 1] = '\n' ->
          add d i " ";
          go (i + 2)
        | '\r' | '\n' | '\t' ->
          add d i " ";
          go (i + 1)
        | c ->
          add d i (String.make 1 c);
          go (i + 1)
    in
    go start;
    finished source d start stop 0 (Buffer.length d.bytes)

let starts raw part i =
  i + String.length part <= String.length raw && String.equal (String.sub raw i (String.length part)) part

let rec find raw part i = if i >= String.length raw || starts raw part i then i else find raw part (i + 1)
let is_space c = c = ' ' || c = '\t' || c = '\n' || c = '\r'

let content source start stop =
  let raw = Source.text source in
  let d = { bytes = Buffer.create (max 16 (stop - start)); places = [||] } in
  let line_end i =
    add d i "\n";
    if i + 1 < stop && raw.[i + 1] = '\n' then i + 2 else i + 1
  in
  let rec go i =
    if i < stop then
      match raw.[i] with
      | '&' ->
        let close = String.index_from raw i ';' in
        add d i (meaning (String.sub raw (i + 1) (close - i - 1)));
        go (close + 1)
      | '<' when starts raw "<!--" i -> go (find raw "-->" (i + 4) + 3)
      | '<' when starts raw "<?" i -> go (find raw "?>" i + 2)
      | '<' -> section (i + 9)
      | '\r' -> go (line_end i)
      | c ->
        add d i (String.make 1 c);
        go (i + 1)
  and section i =
    if i < stop then
      if starts raw "]]>" i then go (i + 3)
      else if raw.[i] = '\r' then section (line_end i)
      else begin
        add d i (String.make 1 raw.[i]);
        section (i + 1)
      end
  in
  go start;
  let text = Buffer.contents d.bytes in
  let rec first i = if i < String.length text && is_space text.[i] then first (i + 1) else i in
  let first = first 0 in
  let rec last i = if i > first && is_space text.[i - 1] then last (i - 1) else i in
  finished source d start stop first (last (String.length text))
