open Scc_exact
open Scc_semantics
open Scc_verify

type choice = { action : string; duration : Rat.t; targets : (int * Rat.t) list }
type t = { labelling : Labelling.t; names : Safe_names.t; choices : int; transitions : int }

let loops = [ "rest"; "stuck"; "unexplored" ]
let labelling m = m.labelling
let states m = Labelling.size m.labelling

let named names space label =
  Safe_names.name names (Transition.label_to_string (Explored.model space) label)

let action m label = named m.names (Labelling.space m.labelling) label
let surely target = [ (target, Rat.one) ]
let passing m d ~target = { action = action m (Time d); duration = d; targets = surely target }
let loop action target = { action; duration = Rat.zero; targets = surely target }

(* Each target once, in order. *)
let distinct = Scc_data.Lists.merged Int.compare Rat.add

(* What chance decides is one choice: to let it. *)
let draw m (edge : Explored.edge) outcomes =
  let model = Explored.model (Labelling.space m.labelling) in
  let text =
    match edge.label with
    | Draw { first; _ } -> Printf.sprintf "draw(%s)" model.leaves.(first).name
    | Lot { bond; decision = First; _ } -> Printf.sprintf "first(%s)" (Transition.bond_to_string model bond)
    | Lot { bond; _ } -> Printf.sprintf "lot(%s)" (Transition.bond_to_string model bond)
    | Time _ | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ -> "tie"
  in
  { action = Safe_names.name m.names text; duration = Rat.zero; targets = distinct outcomes }

let of_stretch m (s : Labelling.stretch) =
  match s.lasts with
  | None -> [ loop "rest" s.target ]
  | Some d -> [ passing m d ~target:s.target ]

let of_state m i =
  let space = Labelling.space m.labelling in
  let detour = Labelling.detour m.labelling i in
  let choice (e : Explored.edge) =
    match (e.label, detour) with
    | Time _, Some (d, target) -> passing m d ~target
    | label, _ ->
      { action = action m label; duration = Transition.duration_of label; targets = surely e.target }
  in
  match (Labelling.status m.labelling i, detour) with
  | Unexplored, _ -> [ loop "unexplored" i ]
  | Stuck, _ -> [ loop "stuck" i ]
  | Rests, None -> [ loop "rest" i ]
  | Rests, Some (d, target) -> [ passing m d ~target ]
  | Moves, _ -> (
      let outcome (e : Explored.edge) = Option.map (fun chance -> (e, (e.target, chance))) e.chance in
      let edges = Array.to_list (space.edges i) in
      let others = List.filter (fun (e : Explored.edge) -> Option.is_none e.chance) edges in
      match List.filter_map outcome edges with
      | [] -> List.map choice edges
      | (first, _) :: _ as drawn -> draw m first (List.map snd drawn) :: List.map choice others)

let choices m i =
  match Labelling.stretch m.labelling i with
  | Some s -> of_stretch m s
  | None -> of_state m i

(* Names are given in the order of the states, whatever is written first. *)
let make labelling =
  let m = { labelling; names = Safe_names.make ~reserved:loops; choices = 0; transitions = 0 } in
  let rec from i m =
    if i = states m then m
    else
      let here = choices m i in
      let outcomes = List.fold_left (fun n c -> n + List.length c.targets) 0 here in
      from (i + 1) { m with choices = m.choices + List.length here; transitions = m.transitions + outcomes }
  in
  from 0 m

let count m = m.choices
let transitions m = m.transitions

let status_label l i =
  let of_state i =
    match Labelling.status l i with
    | Moves -> []
    | Rests -> [ "quiescent" ]
    | Stuck -> [ "deadlock" ]
    | Unexplored -> [ "unexplored" ]
  in
  match Labelling.stretch l i with
  | None -> of_state i
  | Some s -> of_state s.source @ if s.attained then [] else [ "right_after" ]

let labels m i =
  let l = m.labelling in
  let predicates = Labelling.predicates l in
  let rec holding k found =
    if k < 0 then found
    else
      holding (k - 1)
        (if Labelling.holds l i k then predicates.(k).name :: found else found)
  in
  (if i = 0 then [ "init" ] else []) @ status_label l i @ holding (Array.length predicates - 1) []

let label_names m =
  State_predicates.reserved
  @ List.map (fun (p : State_predicates.t) -> p.name) (Array.to_list (Labelling.predicates m.labelling))

let occurs m =
  let found = Hashtbl.create 64 in
  for i = 0 to states m - 1 do
    List.iter (fun name -> Hashtbl.replace found name ()) (labels m i)
  done;
  Hashtbl.mem found

let actions m = Safe_names.listed m.names
