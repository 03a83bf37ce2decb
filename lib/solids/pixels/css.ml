open Svg_number

type subject = { name : string; id : string option; classes : string list }
type declaration = { property : string; value : string; important : bool }

(* Selectors without anything between them; [never] is for what depends on a pointer. *)
type compound = { of_name : string option; ids : string list; of_classes : string list; root : bool; never : bool }

(* The last compound, and before it each with how it is joined to the one after it, the nearest first. *)
type selector = { last : compound; around : ([ `Child | `Within ] * compound) list; weight : int * int * int }
type rule = selector * declaration list
type t = { rules : rule list; mutable steps : int }

let max_selectors = 1_000
let max_steps = 100_000_000
let bad format = Printf.ksprintf (fun m -> raise (Bad m)) format
let unread format = Printf.ksprintf (fun m -> raise (Unread m)) format

(* {1 Texts} *)

let find text from what =
  let n = String.length what in
  let rec go i =
    if i + n > String.length text then None else if String.sub text i n = what then Some i else go (i + 1)
  in
  go from

let without_comments text =
  let b = Buffer.create (String.length text) in
  let rec go at =
    match find text at "/*" with
    | None -> Buffer.add_substring b text at (String.length text - at)
    | Some start -> (
        Buffer.add_substring b text at (start - at);
        Buffer.add_char b ' ';
        match find text (start + 2) "*/" with
        | None -> ()
        | Some stop -> go (stop + 2))
  in
  go 0;
  Buffer.contents b

(* The first place of one of the characters that is neither in quotes nor in parentheses, from [at] on. *)
let first_of text at wanted =
  let rec go i depth quote =
    if i >= String.length text then None
    else
      match (text.[i], quote) with
      | c, Some q -> go (i + 1) depth (if c = q then None else quote)
      | (('"' | '\'') as q), None -> go (i + 1) depth (Some q)
      | '(', None -> go (i + 1) (depth + 1) None
      | ')', None -> go (i + 1) (depth - 1) None
      | c, None -> if depth <= 0 && List.mem c wanted then Some i else go (i + 1) depth None
  in
  go at 0 None

let split text wanted =
  let rec go at found =
    match first_of text at [ wanted ] with
    | Some i -> go (i + 1) (String.sub text at (i - at) :: found)
    | None -> List.rev (String.sub text at (String.length text - at) :: found)
  in
  go 0 []

(* {1 Declarations} *)

let declaration text =
  match first_of text 0 [ ':' ] with
  | None -> bad "the declaration %S without a colon" (String.trim text)
  | Some i ->
    if String.contains text '\\' then unread "a style with escapes (\\)";
    let property = String.lowercase_ascii (String.trim (String.sub text 0 i)) in
    let value = String.trim (String.sub text (i + 1) (String.length text - i - 1)) in
    let bang = String.index_opt value '!' in
    let word j = String.lowercase_ascii (String.trim (String.sub value (j + 1) (String.length value - j - 1))) in
    match bang with
    | Some j when word j = "important" -> { property; value = String.trim (String.sub value 0 j); important =
                                                                                                    true }
    | _ -> { property; value; important = false }

(* CSS has no numbers that end with a point; attributes do. *)
let ends_with_point value =
  let digit i = i >= 0 && i < String.length value && value.[i] >= '0' && value.[i] <= '9' in
  let ends i = value.[i] = '.' && digit (i - 1) && not (digit (i + 1)) in
  let quoted = String.exists (fun c -> c = '"' || c = '\'' || c = '#') value in
  (not quoted) && List.exists ends (List.init (String.length value) Fun.id)

(* Of a block: what is not valid is ignored where another value of the property is before it. *)
let valid_of ~valid block =
  let known = Hashtbl.create 8 in
  let counts d =
    let good = valid d.property d.value && not (ends_with_point d.value) in
    let before = Hashtbl.mem known d.property in
    if good then Hashtbl.replace known d.property ();
    good || not before
  in
  List.filter counts block

let declarations_of ~valid text =
  let one part = if String.trim part = "" then None else Some (declaration part) in
  valid_of ~valid (List.filter_map one (split text ';'))

let declarations ~valid text = declarations_of ~valid (without_comments text)

(* {1 Selectors} *)

let is_name = function
  | 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '-' | '_' | '\128' .. '\255' -> true
  | _ -> false

let anything = { of_name = None; ids = []; of_classes = []; root = false; never = false }

let pseudo found = function
  | "root" -> { found with root = true }
  | "hover" | "active" | "focus" | "visited" -> { found with never = true }
  | word -> unread "the selector \":%s\"" word

(* The compound at a place, and the place after it. *)
let compound text at =
  let name from =
    let rec stop i = if i < String.length text && is_name text.[i] then stop (i + 1) else i in
    let stop = stop from in
    if stop = from then bad "the selector %S" (String.trim text);
    (String.sub text from (stop - from), stop)
  in
  let rec go i found =
    if i >= String.length text then (found, i)
    else
      match text.[i] with
      | '#' -> let id, i = name (i + 1) in go i { found with ids = id :: found.ids }
      | '.' -> let c, i = name (i + 1) in go i { found with of_classes = c :: found.of_classes }
      | ':' -> let word, i = name (i + 1) in go i (pseudo found (String.lowercase_ascii word))
      | '[' -> unread "selectors by attributes"
      | '+' | '~' -> unread "selectors by what is beside"
      | _ -> (found, i)
  in
  match text.[at] with
  | '*' -> go (at + 1) anything
  | c when is_name c -> let of_name, i = name at in go i { anything with of_name = Some of_name }
  | _ ->
    let found, i = go at anything in
    if i = at then bad "the selector %S" (String.trim text);
    (found, i)

let weight compounds =
  let count f = List.fold_left (fun n c -> n + f c) 0 compounds in
  ( count (fun c -> List.length c.ids),
    count (fun c -> List.length c.of_classes + if c.root then 1 else 0),
    count (fun c -> if c.of_name = None then 0 else 1) )

let selector text =
  let text = String.trim text in
  if text = "" then bad "a rule of a style sheet without a selector";
  let n = String.length text in
  (* Blanks between compounds, with ">" among them or without it. *)
  let rec gap i child =
    if i < n && is_blank text.[i] then gap (i + 1) child
    else if i < n && text.[i] = '>' then if child then bad "the selector %S" text else gap (i + 1) true
    else (i, if child then `Child else `Within)
  in
  let rec go last around i =
    if i >= n then { last; around; weight = weight (last :: List.map snd around) }
    else
      let i, joined = gap i false in
      if i >= n then bad "the selector %S" text;
      let next, i = compound text i in
      go next ((joined, last) :: around) i
  in
  let first, i = compound text 0 in
  go first [] i

(* {1 Rules} *)

let rule_at text at =
  match first_of text at [ '{'; '}' ] with
  | Some i when text.[i] = '{' -> (
      match first_of text (i + 1) [ '{'; '}' ] with
      | Some j when text.[j] = '}' -> (String.sub text at (i - at), String.sub text (i + 1) (j - i - 1), j + 1)
      | _ -> bad "a style sheet with braces that do not match")
  | _ -> bad "a style sheet with a rule that has no braces"

let at_rule text at =
  let rec stop i = if i < String.length text && is_name text.[i] then stop (i + 1) else i in
  let stop = stop (at + 1) in
  match String.lowercase_ascii (String.sub text at (stop - at)) with
  | "@charset" -> (
      match String.index_from_opt text at ';' with
      | Some i -> i + 1
      | None -> bad "a rule \"@charset\" without its end")
  | "@font-face" -> let _, _, next = rule_at text at in next
  | name -> unread "the rule %S of a style sheet" name

let rules ~valid text =
  let text = without_comments text in
  let n = String.length text in
  let rec go at found =
    if at >= n then found
    else if is_blank text.[at] then go (at + 1) found
    else if find (String.sub text at (min 4 (n - at))) 0 "<!--" = Some 0 then go (at + 4) found
    else if find (String.sub text at (min 3 (n - at))) 0 "-->" = Some 0 then go (at + 3) found
    else if text.[at] = '@' then go (at_rule text at) found
    else
      let selectors, inner, next = rule_at text at in
      let declared = declarations_of ~valid inner in
      go next (List.rev_append (List.map (fun s -> (selector s, declared)) (split selectors ',')) found)
  in
  List.rev (go 0 [])

let is_empty t = t.rules = []

let sheet rules =
  let rules = List.concat rules in
  if List.compare_length_with rules max_selectors > 0 then
    bad "style sheets with more than %d selectors" max_selectors;
  { rules = List.stable_sort (fun (s, _) (t, _) -> compare s.weight t.weight) rules; steps = 0 }

(* {1 Matching} *)

let fits c ~root subject =
  (not c.never)
  && ((not c.root) || root)
  && (match c.of_name with None -> true | Some name -> String.equal name subject.name)
  && List.for_all (fun id -> subject.id = Some id) c.ids
  && List.for_all (fun name -> List.mem name subject.classes) c.of_classes

let step t n =
  t.steps <- t.steps + n;
  if t.steps > max_steps then bad "style sheets with more selectors than are compared with so many elements"

(* [places] are the parts of the chain that begin with what fits the selector so far, the longest first. For
   `Within only the longest counts. *)
let selects t selector chain =
  let fits c = function [] -> false | subject :: rest -> fits c ~root:(rest = []) subject in
  let rec tails = function [] -> [] | _ :: rest as chain -> chain :: tails rest in
  let rec go around places =
    match (around, places) with
    | _, [] -> false
    | [], _ -> true
    | (joined, c) :: around, longest :: _ ->
      let beyond = function [] -> [] | _ :: rest -> rest in
      let next =
        match joined with
        | `Child -> List.filter_map (function _ :: (_ :: _ as rest) -> Some rest | _ -> None) places
        | `Within -> tails (beyond longest)
      in
      step t (List.length next);
      go around (List.filter (fits c) next)
  in
  step t 1;
  fits selector.last chain && go selector.around [ chain ]

let declared t chain =
  List.concat_map (fun (selector, declared) -> if selects t selector chain then declared else []) t.rules
