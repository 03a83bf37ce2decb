(* Models of cubes in some clusters far from each other, at random, and the same models told in other ways. *)

module Gen = QCheck2.Gen

type vector = int * int * int

(** A summand omega of a leaf, by one of its faces, which are told by their directions. *)
type summand = { face : vector; how : string  (** what stands behind it *); next : int }

type leaf = {
  at : vector;  (** in its cluster *)
  first : summand list;  (** what it offers at first; 0 is what comes next when it does so again *)
  law : (vector * int) list;  (** velocities to choose from, with weights; none where it has no law *)
}

(** Bonds by the leaf that is bound, and where the other one is, seen from it. *)
type cluster = { leaves : leaf list; bonds : (int * int * vector) list; wall : vector option }

type atom =
  | Is of (int * int) * int  (** the behaviour of a leaf of a cluster *)
  | Bound of int * int * int
  | Weakly of (int * int)
  | Gone of (int * int)

type formula = Atom of atom | Not of formula | And of formula * formula | Or of formula * formula

type question = { before : string; within : string; left : formula option; right : formula; after : string }

type model = { clusters : cluster list; timestep : string; questions : question list }

(** How it is told. *)
type way = {
  turn : vector -> vector;
  place : int -> vector;  (** of a cluster *)
  order : int -> int;  (** of declaration: a number for each *)
  name : int -> string;  (** of the leaf of that number, and of behaviours *)
}

let plus (a, b, c) (d, e, f) = (a + d, b + e, c + f)

(* {1 As texts} *)

let face = function
  | 1, 0, 0 -> "right"
  | -1, 0, 0 -> "left"
  | 0, 1, 0 -> "back"
  | 0, -1, 0 -> "front"
  | 0, 0, 1 -> "top"
  | _ -> "bottom"

let opposite (x, y, z) = (-x, -y, -z)
let text (x, y, z) = Printf.sprintf "(%d, %d, %d)" x y z
let most = 8
let number (c, l) = (c * most) + l
let leaf_name way id = "p" ^ way.name (number id)
let behaviour way id k = Printf.sprintf "%s%d" (String.uppercase_ascii ("b" ^ way.name (number id))) k
let wall_name way c = "w" ^ way.name c

let summand way id { face = f; how; next } =
  Printf.sprintf "omega(a, {%s}) %s . %s" (face (way.turn f)) how (behaviour way id next)

let behaviours way id (l : leaf) =
  let first = match l.first with [] -> "nil" | all -> String.concat " + " (List.map (summand way id) all) in
  [
    Printf.sprintf "behaviour %s on Cube = %s" (behaviour way id 0) first;
    Printf.sprintf "behaviour %s on Cube = nil" (behaviour way id 1);
    Printf.sprintf "behaviour %s on Cube = eps(3/2) . %s" (behaviour way id 2) (behaviour way id 1);
  ]

let process way ((c, _) as id) (l : leaf) =
  let at = plus (way.place c) (way.turn l.at) in
  Printf.sprintf "process %s = Cube mass 1 at translate %s [%s]" (leaf_name way id) (text at) (behaviour way id 0)

let motion way id (l : leaf) =
  let kick (v, weight) = Printf.sprintf "%s weight %d" (text (way.turn v)) weight in
  match l.law with
  | [] -> []
  | kicks ->
    [ Printf.sprintf "motion %s = choose { %s }" (leaf_name way id) (String.concat ", " (List.map kick kicks)) ]

let bond way c (i, j, d) =
  let d = way.turn d in
  Printf.sprintf "bond <a, {%s.%s, %s.%s}>" (leaf_name way (c, i)) (face d) (leaf_name way (c, j))
    (face (opposite d))

let wall way c at =
  let at = plus (way.place c) (way.turn at) in
  Printf.sprintf "fixed %s = Cube absorb at translate %s" (wall_name way c) (text at)

let atom way = function
  | Is (id, k) -> Printf.sprintf "behaviour(%s) = %s" (leaf_name way id) (behaviour way id k)
  | Bound (c, i, j) -> Printf.sprintf "bound(%s, %s)" (leaf_name way (c, i)) (leaf_name way (c, j))
  | Weakly id -> Printf.sprintf "event weak(a, %s)" (leaf_name way id)
  | Gone id -> Printf.sprintf "gone(%s)" (leaf_name way id)

let rec formula way = function
  | Atom a -> atom way a
  | Not f -> Printf.sprintf "not (%s)" (formula way f)
  | And (f, g) -> Printf.sprintf "(%s and %s)" (formula way f) (formula way g)
  | Or (f, g) -> Printf.sprintf "(%s or %s)" (formula way f) (formula way g)

let question way i q =
  let right = formula way q.right in
  let path =
    match q.left with
    | Some left -> Printf.sprintf "%s U%s %s" (formula way left) q.within right
    | None -> right
  in
  Printf.sprintf "check c%d : %s%s%s" i q.before path q.after

let numbered list = List.mapi (fun i x -> (i, x)) list

let in_order way list = List.stable_sort (fun (i, _) (j, _) -> Int.compare (way.order i) (way.order j)) list

let to_text way m =
  let all =
    List.concat_map
      (fun (c, cluster) -> List.map (fun (l, leaf) -> ((c, l), leaf)) (numbered cluster.leaves))
      (numbered m.clusters)
  in
  let each f = List.map (fun (id, l) -> (number id, f id l)) all in
  let told list = List.map snd (in_order way list) in
  let walls =
    List.concat_map
      (fun (c, cluster) -> match cluster.wall with Some at -> [ (c, wall way c at) ] | None -> [])
      (numbered m.clusters)
  in
  let bonds =
    List.concat_map (fun (c, cluster) -> List.map (bond way c) cluster.bonds) (numbered m.clusters) |> numbered
  in
  String.concat "\n"
    (List.concat
       [
         [ "split_step 1"; m.timestep; "shape Cube = box(1, 1, 1)" ];
         List.concat (told (each (behaviours way)));
         told walls; told (each (process way)); List.concat (told (each (motion way))); told bonds;
         List.mapi (question way) m.questions;
       ])

(* {1 Models at random} *)

let directions = [ (1, 0, 0); (-1, 0, 0); (0, 1, 0); (0, -1, 0); (0, 0, 1); (0, 0, -1) ]
let direction = Gen.oneofl directions

(* A tree of cubes: each next one beside one that is there, where nobody is. *)
let tree n =
  let open Gen in
  let rec grow places bonds k =
    if k = n then pure (List.rev places, List.rev bonds)
    else
      let* i = int_bound (k - 1) in
      let* d = direction in
      let at = plus (List.nth (List.rev places) i) d in
      if List.mem at places then grow places bonds k else grow (at :: places) ((i, k, d) :: bonds) (k + 1)
  in
  grow [ (0, 0, 0) ] [] 1

(* What one end of a bond offers. Most bonds have lots drawn for them, and most of the other ends can choose. *)
let summands ~pushes kind face =
  let open Gen in
  let push = if pushes then frequencyl [ (3, ""); (1, "push(1)"); (1, "push(2)") ] else pure "" in
  let by (odds, next) = map (fun push -> { face; how = push ^ odds; next }) push in
  let all list = flatten_l (List.map by list) in
  let chance = oneofl [ " chance 1/2"; " chance 1/2"; " chance 1"; " chance 1/3"; " rate 1" ] in
  let again = frequencyl [ (3, 1); (1, 0) ] in
  match kind with
  | `Chance ->
    let* odds = chance and* next = again in
    frequency
      [
        (2, all [ (odds, next) ]); (3, all [ (" chance 1/2", 1); (" chance 1/2", 2) ]);
        (1, all [ (" rate 1", 1); (" chance 1/4", 2) ]); (1, all [ (odds, next); ("", 2) ]);
      ]
  | `Free ->
    let* next = again in
    frequency [ (4, all [ ("", 1); ("", 2) ]); (1, all [ ("", next) ]); (1, all [ ("", next); ("", 2) ]) ]
  | `Nothing -> pure []

(* Of each bond the kinds of its ends, and of each leaf what its ends offer. *)
let kinds =
  Gen.frequencyl
    [
      (6, (`Chance, `Free)); (6, (`Free, `Chance)); (2, (`Chance, `Chance)); (2, (`Free, `Free));
      (1, (`Chance, `Nothing));
    ]

let faces_of bonds l =
  List.concat_map
    (fun ((i, j, d), (one, two)) ->
       (if i = l then [ (one, d) ] else []) @ if j = l then [ (two, opposite d) ] else [])
    bonds

let leaf ~pushes ~laws bonds l at =
  let open Gen in
  let law =
    if not laws then pure []
    else
      let* d = direction and* weight = int_range 1 3 and* still = bool in
      pure ((if still then [ ((0, 0, 0), 1) ] else []) @ [ (d, weight); (opposite d, 1) ])
  in
  let at_face (kind, face) = summands ~pushes kind face in
  let offers = map List.concat (flatten_l (List.map at_face (faces_of bonds l))) in
  map2 (fun first law -> { at; first; law }) offers law

let cluster ~most ~pushes ~laws =
  let open Gen in
  let* n = int_range (if laws then 1 else 2) most in
  let* places, bonds = tree n in
  let* kinds = list_repeat (List.length bonds) kinds in
  let* leaves = flatten_l (List.mapi (leaf ~pushes ~laws (List.combine bonds kinds)) places) in
  let* beside = if laws then map Option.some direction else pure None in
  let reach = List.fold_left (fun far (x, y, z) -> List.fold_left max far [ abs x; abs y; abs z ]) 0 places in
  let wall = Option.map (fun (x, y, z) -> (x * (reach + 2), y * (reach + 2), z * (reach + 2))) beside in
  pure { leaves; bonds; wall }

let atoms clusters ~laws =
  let of_cluster (c, { leaves; bonds; _ }) =
    let of_leaf (l, _) =
      [ Is ((c, l), 1); Is ((c, l), 2) ] @ if laws then [ Gone (c, l) ] else []
    in
    let of_bond (i, j, _) = [ Bound (c, i, j); Weakly (c, i) ] in
    List.concat_map of_leaf (numbered leaves) @ List.concat_map of_bond bonds
  in
  List.concat_map of_cluster (numbered clusters)

let formula_of atoms =
  let open Gen in
  let literal = map2 (fun a k -> if k = 0 then Not (Atom a) else Atom a) (oneofl atoms) (int_bound 4) in
  let both = map2 (fun f g -> And (f, g)) literal literal in
  frequency [ (1, literal); (3, both); (3, map2 (fun f g -> Or (f, g)) both both) ]

let question_of atoms ~moving =
  let open Gen in
  let formula = formula_of atoms in
  let* within = if moving then pure "[<= 2]" else oneofl [ ""; ""; "[<= 2]"; "[1, 2]" ] in
  let* right = formula and* left = formula and* with_left = bool in
  let eventually = Printf.sprintf "eventually%s " within in
  let runs = [ "P = ? [ "; "P = ? [ "; "P = ? [ "; "P <= 1/2 [ "; "P > 1/3 [ " ] in
  let* what = int_bound (if moving then 5 else 6) in
  match what with
  | 5 -> pure { before = "EF" ^ within ^ " ("; within; left = None; right; after = ")" }
  | 6 -> pure { before = "E = ? [ time U "; within; left = None; right; after = " ]" }
  | _ ->
    let+ run = oneofl runs in
    if with_left then { before = run; within; left = Some left; right; after = " ]" }
    else { before = run ^ eventually; within; left = None; right; after = " ]" }

let model ~laws =
  let open Gen in
  let* n = int_range 2 3 and* pushes = if laws then pure false else frequencyl [ (3, false); (1, true) ] in
  let* clusters = list_repeat n (cluster ~most:(if laws then 2 else if n = 2 then 4 else 3) ~pushes ~laws) in
  let atoms = atoms clusters ~laws in
  let* questions = list_repeat 5 (question_of atoms ~moving:(pushes || laws)) in
  let+ timestep = if laws then oneofl [ ""; "timestep 1 steady"; "timestep 1 local" ] else pure "" in
  { clusters; timestep; questions }

(* {1 Ways to tell them} *)

let rotations =
  let axes = [ (fun (x, y, z) -> (x, y, z)); (fun (x, y, z) -> (y, z, x)); (fun (x, y, z) -> (z, x, y)) ] in
  let quarter (x, y, z) = (-y, x, z) in
  let half v = quarter (quarter v) in
  let about = [ Fun.id; quarter; half; (fun v -> half (quarter v)) ] in
  let over = [ (fun v -> v); (fun (x, y, z) -> (x, -y, -z)) ] in
  List.concat_map
    (fun f -> List.concat_map (fun g -> List.map (fun h v -> f (g (h v))) over) about)
    axes

let as_it_is =
  { turn = Fun.id; place = (fun c -> (40 * c, 0, 0)); order = Fun.id; name = (fun i -> "x" ^ string_of_int i) }

(* Places are in cells of 40 of a lattice, each cluster in one of its own. *)
let way =
  let open Gen in
  let* turn = oneofl rotations in
  let* cells = shuffle_l (List.concat_map (fun x -> List.map (fun y -> (x, y)) [ -1; 0; 1 ]) [ -1; 0; 1 ]) in
  let numbers = shuffle_l (List.init 32 Fun.id) in
  let* shift = int_range (-3) 3 and* orders = numbers and* names = numbers in
  let place c =
    let x, y = List.nth cells c in
    ((40 * x) + shift, 40 * y, shift * c)
  in
  pure
    { turn; place; order = List.nth orders; name = (fun i -> Printf.sprintf "n%d" (List.nth names i)) }
