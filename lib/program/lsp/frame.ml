(* What has been fed and not used yet is in [bytes], from [from] to [stop]. [skip] bytes to come belong to a
   message that is too large, or to a header without an end. *)
type t = {
  most : int;
  mutable bytes : Bytes.t;
  mutable from : int;
  mutable stop : int;
  mutable skip : int;
  mutable lost : bool;  (* a header has no end: its next lines are dropped up to one that begins a header *)
}

type piece = Message of string | Fault of string | More

let most_of_header = 8192
let make ~most = { most; bytes = Bytes.create 65536; from = 0; stop = 0; skip = 0; lost = false }

let reserve t n =
  let used = t.stop - t.from in
  if t.stop + n > Bytes.length t.bytes then begin
    let size = Int.max 65536 (if used + n > Bytes.length t.bytes then 2 * (used + n) else Bytes.length t.bytes) in
    let fresh = if size = Bytes.length t.bytes then t.bytes else Bytes.create size in
    Bytes.blit t.bytes t.from fresh 0 used;
    t.bytes <- fresh;
    t.from <- 0;
    t.stop <- used
  end

let feed t bytes n =
  let skipped = Int.min t.skip n in
  t.skip <- t.skip - skipped;
  let n = n - skipped in
  reserve t n;
  Bytes.blit bytes skipped t.bytes t.stop n;
  t.stop <- t.stop + n

(* {1 Headers} *)

(* The end of a line, and where the next one begins. *)
let line t from =
  match Bytes.index_from_opt t.bytes from '\n' with
  | Some i when i < t.stop ->
    let stop = if i > from && Bytes.get t.bytes (i - 1) = '\r' then i - 1 else i in
    Some (Bytes.sub_string t.bytes from (stop - from), i + 1)
  | Some _ | None -> None

(* The fields of a header and where its content begins. *)
let rec header t from fields =
  if from >= t.stop then None
  else
    match line t from with
    | None -> None
    | Some ("", next) -> Some (List.rev fields, next)
    | Some (text, next) -> header t next (text :: fields)

let field text =
  match String.index_opt text ':' with
  | None -> None
  | Some i ->
    let value = String.trim (String.sub text (i + 1) (String.length text - i - 1)) in
    Some (String.lowercase_ascii (String.trim (String.sub text 0 i)), value)

let is_digits s = String.length s > 0 && String.length s <= 15 && String.for_all (fun c -> c >= '0' && c <= '9') s

(* Whether a content type names no other encoding than UTF-8. *)
let readable_type value =
  let lower = String.lowercase_ascii value in
  match String.split_on_char '=' lower with
  | [ _ ] -> true
  | [ _; charset ] -> List.mem (String.trim charset) [ "utf-8"; "utf8"; "\"utf-8\"" ]
  | _ -> false

let length_of fields =
  let found = List.map field fields in
  if List.mem None found then Error "a line of a header is no field"
  else
    let all = List.filter_map Fun.id found in
    match List.filter (fun (name, _) -> String.equal name "content-length") all with
    | [ (_, value) ] when is_digits value -> (
        match List.assoc_opt "content-type" all with
        | Some kind when not (readable_type kind) -> Error "a message is not in UTF-8"
        | Some _ | None -> Ok (int_of_string value))
    | [ _ ] -> Error "Content-Length is not a number of bytes"
    | [] -> Error "a header has no Content-Length"
    | _ :: _ :: _ -> Error "a header has Content-Length twice"

(* {1 Pieces} *)

let skip t n =
  let there = Int.min n (t.stop - t.from) in
  t.from <- t.from + there;
  t.skip <- n - there

(* Where a header begins in a line: content without a length may stand before it. *)
let beginning text =
  let mark = "content-length:" in
  let lower = String.lowercase_ascii text and n = String.length mark in
  let rec find i =
    if i < 0 then None else if String.equal (String.sub lower i n) mark then Some i else find (i - 1)
  in
  find (String.length text - n)

(* Drops lines up to one in which a header begins. *)
let rec resume t =
  match line t t.from with
  | Some (text, next) -> (
      match beginning text with
      | Some i ->
        t.from <- t.from + i;
        t.lost <- false
      | None ->
        t.from <- next;
        resume t)
  | None -> if t.stop - t.from > most_of_header then t.from <- t.stop

let rec next t =
  if t.lost then resume t;
  if t.lost || t.from = t.stop then More
  else
    match header t t.from [] with
    | None ->
      if t.stop - t.from > most_of_header then begin
        t.lost <- true;
        Fault "a header has no end"
      end
      else More
    | Some ([], start) ->
      t.from <- start;
      next t
    | Some (fields, start) -> (
        match length_of fields with
        | Error why ->
          t.from <- start;
          t.lost <- true;
          Fault why
        | Ok n when n > t.most ->
          t.from <- start;
          skip t n;
          Fault (Printf.sprintf "a message has %d bytes: the most is %d" n t.most)
        | Ok n when t.stop - start < n ->
          reserve t (n - (t.stop - start));
          More
        | Ok n ->
          t.from <- start + n;
          Message (Bytes.sub_string t.bytes start n))

let framed text = Printf.sprintf "Content-Length: %d\r\n\r\n%s" (String.length text) text
