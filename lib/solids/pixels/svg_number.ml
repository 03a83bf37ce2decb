open Scc_exact

exception Bad of string
exception Unread of string
exception Beyond of string

type cursor = { text : string; mutable at : int; mutable first : bool  (** no comma may stand here *) }

let cursor text = { text; at = 0; first = true }
let bad format = Printf.ksprintf (fun m -> raise (Bad m)) format
let peek c = if c.at < String.length c.text then Some c.text.[c.at] else None
let is_blank = function ' ' | '\t' | '\n' | '\r' | '\012' -> true | _ -> false

let rec blanks c =
  match peek c with
  | Some x when is_blank x ->
    c.at <- c.at + 1;
    blanks c
  | _ -> ()

(* Between numbers there may be one comma. *)
let skip c =
  blanks c;
  if (not c.first) && peek c = Some ',' then begin
    c.at <- c.at + 1;
    blanks c
  end;
  c.first <- false

let ended c =
  blanks c;
  c.at >= String.length c.text

let is_small x = x >= 'a' && x <= 'z'

let digits c =
  let start = c.at in
  let rec go () = match peek c with Some '0' .. '9' -> c.at <- c.at + 1; go () | _ -> () in
  go ();
  c.at - start

let sign c = match peek c with Some ('+' | '-') -> c.at <- c.at + 1 | _ -> ()

let missing c =
  let rest = String.sub c.text c.at (String.length c.text - c.at) in
  (match String.index_opt rest '(' with
   | Some i when i > 0 && String.for_all is_small (String.sub rest 0 i) ->
     raise (Unread (Printf.sprintf "the function %s() in %S: write its value" (String.sub rest 0 i) c.text))
   | Some _ | None -> ());
  bad "a number is missing at %S" (String.sub rest 0 (min 12 (String.length rest)))

let number c =
  skip c;
  let start = c.at in
  sign c;
  let before = digits c in
  let after = match peek c with Some '.' -> c.at <- c.at + 1; digits c | _ -> 0 in
  if before + after = 0 then begin
    c.at <- start;
    missing c
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
  if c.at - start > 40 then raise (Unread "a number of more than 40 characters");
  let negative = mantissa.[0] = '-' in
  let unsigned t = if t.[0] = '+' || t.[0] = '-' then String.sub t 1 (String.length t - 1) else t in
  let plain = unsigned mantissa in
  let first = if before = 0 then "0" else "" in
  let last = if String.contains plain '.' && after = 0 then "0" else "" in
  let literal = first ^ plain ^ last in
  let power =
    match int_of_string_opt (if exponent.[0] = '+' then unsigned exponent else exponent) with
    | Some n when abs n <= 9 -> n
    | _ -> raise (Unread "a number with an exponent beyond 9")
  in
  match Rat.of_literal literal with
  | Ok q ->
    let ten = Rat.make (Z.pow (Z.of_int 10) (abs power)) Z.one in
    let q = if power >= 0 then Rat.mul q ten else Rat.div q ten in
    if Rat.compare q (Rat.of_int 1_000_000_000) > 0 then raise (Unread "a number beyond 10^9");
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
  let c = cursor text in
  let rec go n found =
    if ended c then List.rev found
    else if n >= most then bad "a list of more than %d numbers" most
    else go (n + 1) (number c :: found)
  in
  go 0 []

let words text =
  let c = cursor text in
  let in_word i = i < String.length text && not (is_blank text.[i] || text.[i] = ',') in
  let rec stop i = if in_word i then stop (i + 1) else i in
  let rec go found =
    if ended c then List.rev found
    else begin
      skip c;
      let start = c.at in
      c.at <- stop start;
      if c.at = start then bad "a list with a comma too many: %S" text;
      go (String.sub text start (c.at - start) :: found)
    end
  in
  go []

let with_unit text =
  let c = cursor text in
  let q = number c in
  let start = c.at in
  let rec stop i =
    match if i < String.length text then Char.lowercase_ascii text.[i] else ' ' with
    | 'a' .. 'z' | '%' -> stop (i + 1)
    | _ -> i
  in
  c.at <- stop start;
  let unit = String.lowercase_ascii (String.sub text start (c.at - start)) in
  if not (ended c) then bad "more than a number with its unit: %S" text;
  (q, unit)

(* Of CSS, that depend on something else. *)
let other_units =
  String.split_on_char ' '
    "em rem ex rex cap rcap ch rch ic ric lh rlh q vw vh vi vb vmin vmax svw svh svi svb svmin svmax lvw lvh lvi \
     lvb lvmin lvmax dvw dvh dvi dvb dvmin dvmax cqw cqh cqi cqb cqmin cqmax %"

let length ?whole text =
  let q, unit = with_unit text in
  let times n d = Rat.mul q (Rat.make (Z.of_int n) (Z.of_int d)) in
  match (unit, whole) with
  | ("" | "px"), _ -> q
  | "%", Some whole -> Rat.mul whole (Rat.div q (Rat.of_int 100))
  | "pt", _ -> times 4 3
  | "pc", _ -> times 16 1
  | "mm", _ -> times 480 127
  | "cm", _ -> times 4800 127
  | "in", _ -> times 96 1
  | _ when List.mem unit other_units -> raise (Unread (Printf.sprintf "lengths in %S" unit))
  | _ -> bad "the length %S" text

let share text =
  let clamp q = Rat.max Rat.zero (Rat.min Rat.one q) in
  match with_unit text with
  | q, "" -> clamp q
  | q, "%" -> clamp (Rat.div q (Rat.of_int 100))
  | _ -> bad "the share %S" text
