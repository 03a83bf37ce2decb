type t = { rule : string; file : string; line : int }

let is_word c = match c with 'A' .. 'Z' | 'a' .. 'z' | '0' .. '9' | '_' | '\'' -> true | _ -> false
let is_space c = match c with ' ' | '\n' | '\t' -> true | _ -> false

(* The ids have no underscores. *)
let id_of constructor = String.concat "" (String.split_on_char '_' constructor)

let ids = lazy (List.map Scc_semantics.Rule.id Scc_semantics.Rule.all)
let is_rule id = List.exists (String.equal id) (Lazy.force ids)

(* {1 Reading} *)

let rec skip text i = if i < String.length text && is_space text.[i] then skip text (i + 1) else i
let rec back text i = if i >= 0 && is_space text.[i] then back text (i - 1) else i
let rec word_end text i = if i < String.length text && is_word text.[i] then word_end text (i + 1) else i
let has text i part =
  let n = String.length part in
  i >= 0 && i + n <= String.length text && String.equal (String.sub text i n) part

(* The word at a place, and where what follows it begins. *)
let word text i =
  let stop = word_end text i in
  (String.sub text i (stop - i), skip text stop)

let is_pattern text ~start ~next =
  let before = back text (start - 1) in
  let is_case = before >= 0 && text.[before] = '|' && not (has text (before - 1) "||") in
  is_case
  || has text (before - 7) "function"
  || has text next "->"
  || (has text next "|" && not (has text next "||"))

(* A list goes on with constructors that need no path. *)
let rec listed text next =
  if has text next ";" then
    let name, next = word text (skip text (next + 1)) in
    if is_rule (id_of name) then id_of name :: listed text next else []
  else []

(* Whether a path may end before this place: [Rule.] or [Scc_semantics.Rule.], but not [Some_rule.]. *)
let starts text i = i = 0 || not (is_word text.[i - 1])

let rec starts_of text part from =
  match String.index_from_opt text from part.[0] with
  | None -> []
  | Some i when has text i part && starts text i -> i :: starts_of text part (i + 1)
  | Some i -> starts_of text part (i + 1)

(* {1 Finding} *)

let line text i =
  let n = ref 1 in
  String.iteri (fun k c -> if k < i && c = '\n' then incr n) text;
  !n

let at text part start =
  let name, next = word text (start + String.length part) in
  let id = id_of name in
  if is_rule id && not (is_pattern text ~start ~next) then id :: listed text next else []

(* A field [rules], too, gives constructors that need no path. *)
let openings = [ "Rule."; "rules = [ "; "rules = " ]

let in_file file =
  let text = Tree.read file in
  let of_part part =
    List.concat_map
      (fun start -> List.map (fun rule -> { rule; file; line = line text start }) (at text part start))
      (starts_of text part 0)
  in
  List.concat_map of_part openings

let find () = List.concat_map in_file (List.filter (fun f -> Filename.check_suffix f ".ml") (Tree.files "lib"))
