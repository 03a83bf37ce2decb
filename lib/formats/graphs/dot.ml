open Scc_exact
open Scc_property
open Scc_semantics
open Scc_verify

(* The aims of a check, each a predicate that colours the states in which it holds: what is to be reached, and the
   complement of what is to be kept. *)
let coloured checks =
  List.map
    (fun (name, (aim : State_predicates.aim)) ->
       match aim with
       | Reached p -> (name, true, p)
       | Kept p -> (name, false, Formula.negate p))
    (State_predicates.aims checks)

let predicates checks =
  let predicate (name, _, prop) = { State_predicates.name; text = name; prop } in
  Array.of_list (List.map predicate (coloured checks))

let red = "#f6b8b0"
let green = "#bfe5b8"
let dark_red = "#b3261e"
let dark_green = "#1e7a2e"

(** {2 Texts} *)

(* Between quotes, a line for each item; to the left. *)
let quoted lines =
  let b = Buffer.create 64 in
  let escape = function
    | '"' -> Buffer.add_string b "\\\""
    | '\\' -> Buffer.add_string b "\\\\"
    | '\x00' .. '\x1f' | '\x7f' -> Buffer.add_char b ' '
    | c -> Buffer.add_char b c
  in
  Buffer.add_char b '"';
  List.iteri
    (fun i line ->
       if i > 0 then Buffer.add_string b "\\n";
       String.iter escape line)
    lines;
  Buffer.add_char b '"';
  Buffer.contents b

let html s =
  let b = Buffer.create 64 in
  String.iter
    (function
      | '\x00' .. '\x1f' | '\x7f' -> Buffer.add_char b ' '
      | c -> Scc_base.Markup.add b c)
    s;
  Buffer.contents b

(* Broken after commas where it is long. *)
let wrapped text =
  let add (line, lines) word =
    if String.equal line "" then (word, lines)
    else if String.length line + String.length word > 30 then (word, (line ^ ",") :: lines)
    else (line ^ ", " ^ word, lines)
  in
  let words = List.map String.trim (String.split_on_char ',' text) in
  let last, lines = List.fold_left add ("", []) words in
  List.rev (last :: lines)

(** {2 Marks} *)

type picture = {
  l : Labelling.t;
  space : Explored.t;
  digest : State_digest.t;
  aims : (string * bool) array;  (** the names of the checks, and whether they are goals *)
  marked : bool array;  (** the aims that some mark was about *)
  mutable aged : bool;  (** a behaviour was shown that has aged *)
}

let mark_count p = Array.length p.aims

let marks_at p i =
  List.filter (fun k -> Labelling.holds p.l i k) (List.init (mark_count p) Fun.id)

(* What is met while time passes from a state, both ends left out. *)
let marks_on_the_way p i =
  let rec along j found =
    match Labelling.stretch p.l j with
    | None -> found
    | Some s ->
      let found = List.rev_append (marks_at p j) found in
      if s.target = j then found else along s.target found
  in
  match Labelling.detour p.l i with
  | None -> []
  | Some (_, first) -> List.sort_uniq Int.compare (along first [])

let is_goal p k = snd p.aims.(k)

let colour p marks ~bad ~good =
  if List.exists (fun k -> not (is_goal p k)) marks then Some bad
  else match marks with [] -> None | _ :: _ -> Some good

let mark_text p k =
  let name, goal = p.aims.(k) in
  p.marked.(k) <- true;
  (if goal then "reaches " else "violates ") ^ name

(** {2 Folding} *)

let time_edge (e : Explored.edge) = match e.label with Time d -> Some (d, e.target) | _ -> None

let only_time p i =
  match p.space.edges i with [| e |] -> time_edge e | _ -> None

(* The state before each state that has one edge into it, which is of time; -1 for the others. *)
let before p =
  let n = p.space.size in
  let into = Array.make n 0 and before = Array.make n (-1) in
  for i = 0 to n - 1 do
    Array.iter
      (fun (e : Explored.edge) ->
         into.(e.target) <- into.(e.target) + 1;
         if Option.is_some (time_edge e) then before.(e.target) <- i)
      (p.space.edges i)
  done;
  Array.mapi (fun i b -> if into.(i) = 1 then b else -1) before

let folded p =
  let before = before p in
  let alike i j =
    List.equal String.equal (State_digest.lines p.digest i) (State_digest.lines p.digest j)
    && List.equal Int.equal (marks_at p i) (marks_at p j)
  in
  let fold i b = i > 0 && b >= 0 && b <> i && Option.is_some (only_time p i) && alike i b in
  Array.mapi fold before

(* Where a passing of time leads to, how long it takes in all, in how many steps, and what is met on the way. *)
let rec far p folded (d, target) steps met =
  if folded.(target) then
    match only_time p target with
    | Some (d', next) -> far p folded (Rat.add d d', next) (steps + 1) (met @ marks_on_the_way p target)
    | None -> (d, target, steps, met)
  else (d, target, steps, List.sort_uniq Int.compare met)

(** {2 Nodes and edges} *)

let node p put i =
  let marks = marks_at p i in
  let digest = State_digest.lines p.digest i in
  if List.exists (fun line -> String.length line > 0 && Char.equal line.[String.length line - 1] '*') digest then
    p.aged <- true;
  let met = match Labelling.status p.l i with Rests -> marks_on_the_way p i | _ -> [] in
  let later = List.filter (fun k -> not (List.mem k marks)) met in
  let lines =
    (Printf.sprintf "%d" i :: digest)
    @ List.map (mark_text p) marks
    @ List.map (fun k -> mark_text p k ^ " later") later
  in
  let style, more =
    match Labelling.status p.l i with
    | Moves -> ("rounded,filled", "")
    | Rests -> ("rounded,filled", ", peripheries=2")
    | Stuck -> ("filled", ", shape=octagon")
    | Unexplored -> ("rounded,filled,dashed", "")
  in
  let fill = Option.value (colour p (marks @ later) ~bad:red ~good:green) ~default:"white" in
  put
    (Printf.sprintf "  s%d [label=%s, style=\"%s\", fillcolor=\"%s\"%s]\n" i (quoted lines) style fill more)

let edge p folded put i (e : Explored.edge) =
  match time_edge e with
  | None ->
    let text = Transition.label_to_string (Explored.model p.space) e.label in
    put (Printf.sprintf "  s%d -> s%d [label=%s]\n" i e.target (quoted (wrapped text)))
  | Some passing ->
    let d, target, steps, met = far p folded passing 1 (marks_on_the_way p i) in
    let lines =
      Printf.sprintf "time(%s)" (Rat.to_string d)
      :: (if steps > 1 then [ Printf.sprintf "in %d steps" steps ] else [])
      @ List.map (mark_text p) met
    in
    let shade = Option.value (colour p met ~bad:dark_red ~good:dark_green) ~default:"gray50" in
    put
      (Printf.sprintf "  s%d -> s%d [label=%s, color=\"%s\", fontcolor=\"%s\"]\n" i target (quoted lines) shade
         shade)

let legend p (e : Exported.t) put =
  let row colour text =
    Printf.sprintf "<tr><td bgcolor=\"%s\" width=\"24\"></td><td align=\"left\">%s</td></tr>" colour (html text)
  in
  let plain text = Printf.sprintf "<tr><td></td><td align=\"left\">%s</td></tr>" (html text) in
  let text name =
    match List.find_opt (fun (c : Property.check) -> String.equal c.name name) e.loaded.checks with
    | Some c -> c.text
    | None -> ""
  in
  let of_aim (name, goal) =
    row (if goal then green else red)
      (Printf.sprintf "%s %s: %s" (if goal then "reaches" else "violates") name (text name))
  in
  let status s text = if Labelling.count p.l s > 0 then [ plain text ] else [] in
  let rows =
    List.map plain (Exported.summary e)
    @ List.map of_aim (List.filteri (fun k _ -> p.marked.(k)) (Array.to_list p.aims))
    @ (if p.aged then [ plain "K*: has aged since it became K" ] else [])
    @ status Rests "double border: nothing will ever happen again"
    @ status Stuck "octagon: nothing can happen, not even the passing of time"
    @ status Unexplored "dashed: not explored further"
    @ [ plain "gray: time passes; with a colour: it is so on the way" ]
  in
  put
    (Printf.sprintf
       "  legend [shape=plain, label=<<table border=\"0\" cellborder=\"0\" cellspacing=\"2\">%s</table>>]\n"
       (String.concat "" rows))

let write (e : Exported.t) l ~positions put =
  let space = e.space in
  let aims = Array.of_list (List.map (fun (name, goal, _) -> (name, goal)) (coloured e.loaded.checks)) in
  let p =
    {
      l;
      space;
      digest = State_digest.make ~positions (Explored.model space) ~size:space.size space.state;
      aims;
      marked = Array.map (fun _ -> false) aims;
      aged = false;
    }
  in
  let folded = folded p in
  put (Printf.sprintf "digraph %s {\n" (quoted [ Option.value e.loaded.origin.name ~default:"model" ]));
  put "  node [shape=box, fontname=\"Helvetica\", fontsize=10]\n";
  put "  edge [fontname=\"Helvetica\", fontsize=9]\n";
  put "  start [shape=point]\n  start -> s0\n";
  for i = 0 to space.size - 1 do
    if not folded.(i) then begin
      node p put i;
      Array.iter (edge p folded put i) (space.edges i)
    end
  done;
  legend p e put;
  put "}\n"
