type t = {
  taken : (string, unit) Hashtbl.t;
  names : (string, string) Hashtbl.t;  (** by text *)
  mutable order : (string * string) list;  (** newest first *)
}

let make ~reserved =
  let taken = Hashtbl.create 64 in
  List.iter (fun name -> Hashtbl.replace taken name ()) reserved;
  { taken; names = Hashtbl.create 64; order = [] }

let greatest = 64

let is_digit = function '0' .. '9' -> true | _ -> false
let is_letter = function 'a' .. 'z' | 'A' .. 'Z' -> true | _ -> false

(* What stands for the character at [i], and how many characters it stands for. *)
let word s i =
  let next = if i + 1 < String.length s then s.[i + 1] else ' ' in
  match (s.[i], next) with
  | '<', '=' -> ("_le_", 2)
  | '>', '=' -> ("_ge_", 2)
  | '!', '=' -> ("_ne_", 2)
  | '=', '>' -> ("_implies_", 2)
  | '<', ' ' -> ("_lt_", 1)
  | '>', ' ' -> ("_gt_", 1)
  | '=', _ -> ("_eq_", 1)
  | '-', c when is_digit c -> ("_m", 1)
  | '-', _ -> ("_minus_", 1)
  | '+', _ -> ("_plus_", 1)
  | '*', _ -> ("_times_", 1)
  | '/', _ -> ("_over_", 1)
  | '~', _ -> ("_co_", 1)
  | c, _ when is_letter c || is_digit c -> (String.make 1 c, 1)
  | _ -> ("_", 1)

(* Without underscores at the ends or next to each other. *)
let squeezed s =
  String.split_on_char '_' s |> List.filter (fun w -> String.length w > 0) |> String.concat "_"

let plain text =
  let b = Buffer.create (String.length text) in
  let rec from i =
    if i < String.length text && Buffer.length b < 2 * greatest then begin
      let w, n = word text i in
      Buffer.add_string b w;
      from (i + n)
    end
  in
  from 0;
  let s = squeezed (Buffer.contents b) in
  let s =
    if String.length s = 0 then "p" else if is_letter s.[0] then s else "p_" ^ s
  in
  if String.length s > greatest then String.sub s 0 greatest else s

(* Room is left for the number. *)
let numbered s n =
  let tail = "_" ^ string_of_int n in
  let room = greatest - String.length tail in
  (if String.length s > room then String.sub s 0 room else s) ^ tail

let name t text =
  match Hashtbl.find_opt t.names text with
  | Some name -> name
  | None ->
    let s = plain text in
    let rec free n =
      let candidate = if n = 1 then s else numbered s n in
      if Hashtbl.mem t.taken candidate then free (n + 1) else candidate
    in
    let name = free 1 in
    Hashtbl.replace t.taken name ();
    Hashtbl.replace t.names text name;
    t.order <- (name, text) :: t.order;
    name

let listed t = List.rev t.order
