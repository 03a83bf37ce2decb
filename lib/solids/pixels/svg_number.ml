open Scc_exact

exception Bad of string
exception Unread of string

type cursor = { text : string; mutable at : int }

let bad format = Printf.ksprintf (fun m -> raise (Bad m)) format
let peek c = if c.at < String.length c.text then Some c.text.[c.at] else None
let is_blank = function ' ' | '\t' | '\n' | '\r' | '\012' -> true | _ -> false

let rec skip c =
  match peek c with
  | Some x when is_blank x || x = ',' ->
    c.at <- c.at + 1;
    skip c
  | _ -> ()

let ended c =
  skip c;
  c.at >= String.length c.text

let is_small x = x >= 'a' && x <= 'z'

let digits c =
  let start = c.at in
  let rec go () = match peek c with Some '0' .. '9' -> c.at <- c.at + 1; go () | _ -> () in
  go ();
  c.at - start

let sign c = match peek c with Some ('+' | '-') -> c.at <- c.at + 1 | _ -> ()

let number c =
  skip c;
  let start = c.at in
  sign c;
  let before = digits c in
  let after = match peek c with Some '.' -> c.at <- c.at + 1; digits c | _ -> 0 in
  if before + after = 0 then begin
    c.at <- start;
    (match String.index_from_opt c.text start '(' with
     | Some i when i > start && String.for_all is_small (String.sub c.text start (i - start)) ->
       let name = String.sub c.text start (i - start) in
       raise (Unread (Printf.sprintf "the function %s() in %S: write its value" name c.text))
     | Some _ | None -> ());
    bad "a number is missing at %S" (String.sub c.text start (min 12 (String.length c.text - start)))
  end;
  let mantissa = String.sub c.text start (c.at - start) in
  let mark = c.at in
  let exponent =
    match peek c with
    | Some ('e' | 'E') ->
      c.at <- c.at + 1;
      sign c;
      (* em and ex are units. *)
      if digits c > 0 then String.sub c.text (mark + 1) (c.at - mark - 1) else begin c.at <- mark; "0" end
    | _ -> "0"
  in
  if c.at - start > 40 then bad "a number of more than 40 characters";
  let negative = mantissa.[0] = '-' in
  let unsigned t = if t.[0] = '+' || t.[0] = '-' then String.sub t 1 (String.length t - 1) else t in
  let plain = unsigned mantissa in
  let first = if before = 0 then "0" else "" in
  let last = if String.contains plain '.' && after = 0 then "0" else "" in
  let literal = first ^ plain ^ last in
  let power =
    match int_of_string_opt (if exponent.[0] = '+' then unsigned exponent else exponent) with
    | Some n when abs n <= 9 -> n
    | _ -> bad "a number with an exponent beyond 9"
  in
  match Rat.of_literal literal with
  | Ok q ->
    let ten = Rat.make (Z.pow (Z.of_int 10) (abs power)) Z.one in
    let q = if power >= 0 then Rat.mul q ten else Rat.div q ten in
    if Rat.compare q (Rat.of_int 1_000_000_000) > 0 then bad "a number beyond 10^9";
    if negative then Rat.neg q else q
  | Error _ -> bad "no number: %S" literal

let flag c =
  skip c;
  match peek c with
  | Some (('0' | '1') as x) ->
    c.at <- c.at + 1;
    x = '1'
  | _ -> bad "a flag of an arc that is neither 0 nor 1"

let most = 1_000_000

let all text =
  let c = { text; at = 0 } in
  let rec go n found =
    if ended c then List.rev found
    else if n >= most then bad "a list of more than %d numbers" most
    else go (n + 1) (number c :: found)
  in
  go 0 []

let length ?whole text =
  let c = { text; at = 0 } in
  let q = number c in
  let times n d = Rat.mul q (Rat.make (Z.of_int n) (Z.of_int d)) in
  match (String.lowercase_ascii (String.trim (String.sub text c.at (String.length text - c.at))), whole) with
  | ("" | "px"), _ -> q
  | "%", Some whole -> Rat.mul whole (Rat.div q (Rat.of_int 100))
  | "pt", _ -> times 4 3
  | "pc", _ -> times 16 1
  | "mm", _ -> times 480 127
  | "cm", _ -> times 4800 127
  | "in", _ -> times 96 1
  | unit, _ -> raise (Unread (Printf.sprintf "lengths in %S" unit))
