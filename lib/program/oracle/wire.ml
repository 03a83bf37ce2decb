type t =
  | Null
  | Bool of bool
  | Number of string
  | Text of string
  | List of t list
  | Object of (string * t) list

type reader = { s : string; mutable at : int; mutable values : int; quotas : Quotas.t; scratch : Buffer.t }

let fail r why = Fault.refuse (Parse (r.at, why))
let fail_at at why = Fault.refuse (Parse (at, why))
let limit name most = Fault.refuse (Limit (name, most))

let rec blanks r =
  if r.at < String.length r.s then
    match String.unsafe_get r.s r.at with
    | ' ' | '\t' | '\r' | '\n' ->
      r.at <- r.at + 1;
      blanks r
    | _ -> ()

(* The next character, or one that is never expected. *)
let peek r = if r.at < String.length r.s then String.unsafe_get r.s r.at else '\x00'

let count r =
  r.values <- r.values + 1;
  if r.values > r.quotas.values then limit "values" r.quotas.values

let word r text value =
  let n = String.length text in
  if r.at + n <= String.length r.s && String.equal (String.sub r.s r.at n) text then begin
    r.at <- r.at + n;
    value
  end
  else fail r "a value is expected here"

(* {1 Numbers} *)

let rec digits s i =
  if i < String.length s && String.unsafe_get s i >= '0' && String.unsafe_get s i <= '9' then digits s (i + 1)
  else i

let some_digits r from =
  let stop = digits r.s from in
  if stop = from then fail_at from "a digit is expected here";
  stop

let number r =
  let s = r.s and start = r.at in
  let n = String.length s in
  let first = if s.[start] = '-' then start + 1 else start in
  let stop = some_digits r first in
  if s.[first] = '0' && stop > first + 1 then fail_at first "a number does not begin with 0";
  let stop = if stop < n && s.[stop] = '.' then some_digits r (stop + 1) else stop in
  let stop =
    if stop < n && (s.[stop] = 'e' || s.[stop] = 'E') then
      let signed = stop + 1 < n && (s.[stop + 1] = '-' || s.[stop + 1] = '+') in
      some_digits r (if signed then stop + 2 else stop + 1)
    else stop
  in
  r.at <- stop;
  Number (String.sub s start (stop - start))

(* {1 Strings} *)

let continuation s i = i < String.length s && Char.code (String.unsafe_get s i) land 0xC0 = 0x80

(* The length of the sequence of two bytes or more that is at [i]: none is too long, a surrogate or too great. *)
let sequence r i =
  let s = r.s in
  let second () = if i + 1 < String.length s then Char.code s.[i + 1] else 0 in
  let well k = 
    let rec go j = j > k || (continuation s (i + j) && go (j + 1)) in
    go 1
  in
  let length =
    match s.[i] with
    | '\xc2' .. '\xdf' when well 1 -> 2
    | '\xe0' when well 2 && second () >= 0xA0 -> 3
    | '\xed' when well 2 && second () < 0xA0 -> 3
    | '\xe1' .. '\xec' | '\xee' | '\xef' -> if well 2 then 3 else 0
    | '\xf0' when well 3 && second () >= 0x90 -> 4
    | '\xf4' when well 3 && second () < 0x90 -> 4
    | '\xf1' .. '\xf3' when well 3 -> 4
    | _ -> 0
  in
  if length = 0 then fail_at i "a string that is not UTF-8";
  length

(* Up to where the string goes on without an escape. *)
let rec plain r i =
  if i >= String.length r.s then fail_at i "a string without its end"
  else
    match String.unsafe_get r.s i with
    | '"' | '\\' -> i
    | '\x00' .. '\x1f' -> fail_at i "a control character in a string"
    | '\x20' .. '\x7f' -> plain r (i + 1)
    | _ -> plain r (i + sequence r i)

let hex r i =
  let digit c =
    match c with
    | '0' .. '9' -> Char.code c - 48
    | 'a' .. 'f' -> Char.code c - 87
    | 'A' .. 'F' -> Char.code c - 55
    | _ -> fail_at i "four hexadecimal digits are expected here"
  in
  if i + 4 > String.length r.s then fail_at i "four hexadecimal digits are expected here"
  else
    let d k = digit r.s.[i + k] in
    (d 0 lsl 12) lor (d 1 lsl 8) lor (d 2 lsl 4) lor d 3

(* Adds the scalar value of [\uXXXX] at [i], or of two of them; gives where it ends. *)
let unicode r i =
  let add u = Buffer.add_utf_8_uchar r.scratch (Uchar.of_int u) in
  let u = hex r (i + 2) in
  if u < 0xD800 || u > 0xDFFF then begin
    add u;
    i + 6
  end
  else if u > 0xDBFF || i + 8 > String.length r.s || r.s.[i + 6] <> '\\' || r.s.[i + 7] <> 'u' then
    fail_at i "a lone surrogate"
  else
    let v = hex r (i + 8) in
    if v < 0xDC00 || v > 0xDFFF then fail_at i "a lone surrogate"
    else begin
      add (0x10000 + ((u - 0xD800) lsl 10) + (v - 0xDC00));
      i + 12
    end

let rec escaped r from =
  let i = plain r from in
  Buffer.add_substring r.scratch r.s from (i - from);
  if r.s.[i] = '"' then r.at <- i + 1
  else if i + 1 >= String.length r.s then fail_at i "a string without its end"
  else
    let simple c =
      Buffer.add_char r.scratch c;
      i + 2
    in
    let next =
      match r.s.[i + 1] with
      | ('"' | '\\' | '/') as c -> simple c
      | 'b' -> simple '\b'
      | 'f' -> simple '\x0c'
      | 'n' -> simple '\n'
      | 'r' -> simple '\r'
      | 't' -> simple '\t'
      | 'u' -> unicode r i
      | _ -> fail_at i "an escape that JSON does not have"
    in
    escaped r next

let text r =
  let start = r.at + 1 in
  let stop = plain r start in
  if String.unsafe_get r.s stop = '"' then begin
    r.at <- stop + 1;
    String.sub r.s start (stop - start)
  end
  else begin
    Buffer.clear r.scratch;
    escaped r start;
    let s = Buffer.contents r.scratch in
    if String.length s > 65536 then Buffer.reset r.scratch;
    s
  end

(* {1 Values} *)

module Names = Set.Make (String)

let few = 16

(* Requests have a few members each: those are compared one by one. *)
let new_name r start known count name members =
  let twice =
    if count <= few then List.exists (fun (other, _) -> String.equal name other) members
    else begin
      if count = few + 1 then known := Names.of_list (List.map fst members);
      let again = Names.mem name !known in
      known := Names.add name !known;
      again
    end
  in
  if twice then fail_at start "a member is given twice";
  ignore r

let rec value r depth =
  blanks r;
  count r;
  match peek r with
  | '"' -> Text (text r)
  | '{' -> Object (enter r depth '}' members)
  | '[' -> List (enter r depth ']' items)
  | '-' | '0' .. '9' -> number r
  | 't' -> word r "true" (Bool true)
  | 'f' -> word r "false" (Bool false)
  | 'n' -> word r "null" Null
  | _ -> fail r "a value is expected here"

and enter : type a. reader -> int -> char -> (reader -> int -> a list) -> a list =
  fun r depth closing inside ->
  if depth >= r.quotas.depth then limit "depth" r.quotas.depth;
  r.at <- r.at + 1;
  blanks r;
  if peek r = closing then begin
    r.at <- r.at + 1;
    []
  end
  else inside r (depth + 1)

and items r depth =
  let rec more acc =
    let acc = value r depth :: acc in
    blanks r;
    match peek r with
    | ',' ->
      r.at <- r.at + 1;
      more acc
    | ']' ->
      r.at <- r.at + 1;
      List.rev acc
    | _ -> fail r "`,` or `]` is expected here"
  in
  more []

and members r depth =
  let known = ref Names.empty in
  let rec more n acc =
    blanks r;
    let start = r.at in
    if peek r <> '"' then fail r "the name of a member is expected here";
    count r;
    let name = text r in
    new_name r start known n name acc;
    blanks r;
    if peek r <> ':' then fail r "`:` is expected here";
    r.at <- r.at + 1;
    let acc = (name, value r depth) :: acc in
    blanks r;
    match peek r with
    | ',' ->
      r.at <- r.at + 1;
      more (n + 1) acc
    | '}' ->
      r.at <- r.at + 1;
      List.rev acc
    | _ -> fail r "`,` or `}` is expected here"
  in
  more 1 []

let parse quotas s =
  let r = { s; at = 0; values = 0; quotas; scratch = Buffer.create 64 } in
  match
    let v = value r 0 in
    blanks r;
    if r.at < String.length s then fail r "the line goes on after its value";
    v
  with
  | v -> Ok v
  | exception Fault.Refused fault -> Error fault
