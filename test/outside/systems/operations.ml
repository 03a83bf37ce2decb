(* operations COUNT SEED: random pairs of polyhedra, and what lib/solids/polyhedra says of them, as JSON Lines. A
   polyhedron is a list of constraints [normal, relation, right], with relation -1 for <, 0 for = and 1 for <=. *)

open Scc_exact
open Scc_polyhedra

(* {1 Random polyhedra} *)

let between state low high = low + Random.State.int state (high - low + 1)

let normal state n =
  Array.init n (fun _ -> if between state 0 2 = 0 then 0 else between state (-3) 3)

(* Mostly through the point, or on the right side of it, so that many constraints have a point in common. *)
let relation state : Constraint.relation =
  match between state 0 9 with
  | 0 -> Equal
  | 1 | 2 | 3 -> Less
  | _ -> At_most

let constraint_ state point =
  let n = Array.length point in
  let normal = normal state n and relation = relation state in
  let there = Array.fold_left ( + ) 0 (Array.map2 ( * ) normal point) in
  let slack =
    match (relation, between state 0 9) with
    | Equal, k -> if k = 0 then 1 else 0
    | _, 0 -> -1
    | Less, _ -> between state 1 6
    | At_most, _ -> between state 0 6
  in
  Constraint.make (Array.map Z.of_int normal) relation (Z.of_int (there + slack))

let system state n =
  let point = Array.init n (fun _ -> between state (-3) 3) in
  List.init (between state 0 9) (fun _ -> constraint_ state point)

(* The constraints of another one, changed a little: such pairs include each other, touch, or can be merged. *)
let relative state n constraints =
  let changed (c : Constraint.t) =
    match between state 0 5 with
    | 0 -> []
    | 1 -> [ Constraint.make c.normal c.relation (Z.add c.right Z.one) ]
    | 2 -> [ Constraint.strict c ]
    | 3 -> Constraint.halves c
    | _ -> [ c ]
  in
  match constraints with
  | cut :: rest when between state 0 2 = 0 -> List.hd (Constraint.negation cut) :: rest
  | _ ->
    let kept = List.concat_map changed constraints in
    if between state 0 1 = 0 then kept else kept @ List.filteri (fun i _ -> i = 0) (system state n)

let form state n =
  Linear.make
    ~constant:(Rat.make (Z.of_int (between state (-5) 5)) (Z.of_int (between state 1 4)))
    (Array.init n (fun _ -> Rat.of_int (between state (-3) 3)))

(* {1 JSON} *)

let list print items = "[" ^ String.concat "," (List.map print items) ^ "]"
let number = Z.to_string
let rational x = "\"" ^ Rat.to_string x ^ "\""

let constraint_json (c : Constraint.t) =
  let relation = match c.relation with Less -> "-1" | Equal -> "0" | At_most -> "1" in
  "[" ^ list number (Array.to_list c.normal) ^ "," ^ relation ^ "," ^ number c.right ^ "]"

let system_json = list constraint_json
let polyhedron p = system_json (Polyhedron.constraints p)
let option print = function None -> "null" | Some x -> print x
let point = option (fun coordinates -> list rational (Array.to_list coordinates))

let form_json (f : Linear.t) = list rational (f.constant :: Array.to_list f.coefficients)

let bound = function
  | Some (Polyhedron.Bound { value; attained }) -> list Fun.id [ rational value; string_of_bool attained ]
  | Some Unbounded -> "\"unbounded\""
  | None -> "null"

(* {1 Questions} *)

let alone state p =
  let n = Polyhedron.dimension p in
  let f = form state n in
  let forms = Array.init (between state 1 3) (fun _ -> form state n) in
  let back = Array.init n (fun _ -> form state 2) in
  let kept = List.filter (fun _ -> between state 0 1 = 0) (List.init n Fun.id) in
  let onto = Array.of_list (if between state 0 1 = 0 then kept else List.rev kept) in
  [ ("empty", string_of_bool (Polyhedron.is_empty p));
    ("universe", string_of_bool (Polyhedron.is_universe p));
    ("dimension", string_of_int (Polyhedron.affine_dimension p));
    ("bounded", string_of_bool (Polyhedron.is_bounded p));
    ("closed", string_of_bool (Polyhedron.included (Polyhedron.closure p) p));
    ("minimal", polyhedron p);
    ("closure", polyhedron (Polyhedron.closure p));
    ("point", point (Polyhedron.point p));
    ("interior", point (Polyhedron.interior_point p));
    ("form", form_json f);
    ("supremum", bound (Polyhedron.supremum p f));
    ("infimum", bound (Polyhedron.infimum p f));
    ("onto", list string_of_int (Array.to_list onto));
    ("projection", polyhedron (Polyhedron.project p onto));
    ("forms", list form_json (Array.to_list forms));
    ("image", polyhedron (Polyhedron.image p forms));
    ("back", list form_json (Array.to_list back));
    ("preimage", polyhedron (Polyhedron.preimage p ~dimension:2 back)) ]

let together p q =
  let u = Union.of_polyhedra (Polyhedron.dimension p) [ p; q ] in
  [ ("included", string_of_bool (Polyhedron.included p q));
    ("equal", string_of_bool (Polyhedron.equal p q));
    ("disjoint", string_of_bool (Polyhedron.disjoint p q));
    ("intersection", polyhedron (Polyhedron.inter p q));
    ("difference", list polyhedron (Difference.pieces p q));
    ("join", polyhedron (Envelope.join p q));
    ("merge", option polyhedron (Envelope.merge p q));
    ("widening", polyhedron (Envelope.widen p (Envelope.join p q)));
    ("parts", list polyhedron (Union.pieces (Union.disjoint u))) ]

let line state =
  let n = between state 1 4 in
  let first = system state n in
  let second = if between state 0 2 = 0 then system state n else relative state n first in
  let p = Polyhedron.of_constraints n first and q = Polyhedron.of_constraints n second in
  let given = [ ("n", string_of_int n); ("p", system_json first); ("q", system_json second) ] in
  let fields = given @ alone state p @ together p q in
  "{" ^ String.concat "," (List.map (fun (name, value) -> "\"" ^ name ^ "\":" ^ value) fields) ^ "}"

let () =
  let count = int_of_string Sys.argv.(1) and seed = int_of_string Sys.argv.(2) in
  let state = Random.State.make [| seed |] in
  for _ = 1 to count do
    print_endline (line state)
  done
