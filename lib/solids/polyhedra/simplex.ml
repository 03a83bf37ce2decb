open Scc_exact

(* Variables that constraints join, directly or by others, and the system of these. *)
type block = {
  variables : int array;  (** in the order in which the system has them *)
  numbers : int array;  (** of its constraints in the whole, in the order in which the system has them *)
  system : Tableau.t;
}

type t = {
  blocks : block array;  (** by variable: the one that it is in *)
  count : int;  (** of all constraints *)
}

let dimension t = Array.length t.blocks

let universe n =
  let alone i = { variables = [| i |]; numbers = [||]; system = Tableau.universe 1 } in
  { blocks = Array.init n alone; count = 0 }

(* {1 Blocks} *)

let first_of t i = t.blocks.(i).variables.(0) = i

let fold_blocks f start t =
  let result = ref start in
  Array.iteri (fun i block -> if first_of t i then result := f !result block) t.blocks;
  !result

(* The blocks of variables that pass, in the order of the first ones. *)
let blocks_of t passes =
  let found = ref [] in
  let look i block =
    if passes i && not (List.memq block !found) then found := block :: !found
  in
  Array.iteri look t.blocks;
  List.rev !found

let blocks_in t (c : Constraint.t) =
  if Constraint.dimension c <> dimension t then Scc_base.Bug.fail __POS__ "a constraint of another dimension";
  blocks_of t (Constraint.mentions c)

let local_normal block (c : Constraint.t) = Array.map (fun i -> c.normal.(i)) block.variables

(* The constraint, as a block sees it that has all its variables. *)
let local block (c : Constraint.t) = Constraint.make (local_normal block c) c.relation c.right

let with_block t block =
  let blocks = Array.copy t.blocks in
  Array.iter (fun i -> blocks.(i) <- block) block.variables;
  { t with blocks }

let joined = function
  | [ block ] -> block
  | blocks ->
    {
      variables = Array.concat (List.map (fun b -> b.variables) blocks);
      numbers = Array.concat (List.map (fun b -> b.numbers) blocks);
      system = Tableau.join (List.map (fun b -> b.system) blocks);
    }

(* {1 Constraints} *)

let add t c =
  let numbered t = { t with count = t.count + 1 } in
  match blocks_in t c with
  | [] -> if Constraint.truth c = Some true then Some (numbered t) else None
  | blocks ->
    let block = joined blocks in
    let put system =
      numbered (with_block t { block with system; numbers = Array.append block.numbers [| t.count |] })
    in
    Option.map put (Tableau.add block.system (local block c))

let of_constraints n constraints =
  List.fold_left (fun t c -> Option.bind t (fun t -> add t c)) (Some (universe n)) constraints

(* {1 Bounds} *)

type bound = Tableau.bound = Unbounded | Bound of { value : Rat.t; attained : bool }

(* What is said of one block has nothing to do with what is said of another: bounds add up. *)
let sum_of_bounds t (f : Linear.t) of_block =
  if Linear.dimension f <> dimension t then Scc_base.Bug.fail __POS__ "a form of another dimension";
  let add sum block =
    match sum with
    | Unbounded -> Unbounded
    | Bound { value; attained } -> (
        let part = Array.map (Linear.coefficient f) block.variables in
        match of_block block.system (Linear.make ~constant:Rat.zero part) with
        | Unbounded -> Unbounded
        | Bound more -> Bound { value = Rat.add value more.value; attained = attained && more.attained })
  in
  let occurs i = Rat.sign (Linear.coefficient f i) <> 0 in
  List.fold_left add (Bound { value = f.constant; attained = true }) (blocks_of t occurs)

let infimum t f = sum_of_bounds t f Tableau.infimum
let supremum t f = sum_of_bounds t f Tableau.supremum

(* {1 Asking} *)

let satisfied (relation : Constraint.relation) ~room:(q, k) =
  let sign = if Rat.sign q <> 0 then Rat.sign q else Rat.sign k in
  match relation with
  | Equal -> sign = 0
  | Less -> sign > 0
  | At_most -> sign >= 0

let satisfies t (c : Constraint.t) =
  match blocks_in t c with
  | [ block ] -> Tableau.satisfies block.system (local block c)
  | blocks ->
    let take (q, k) block =
      let q', k' = Tableau.value block.system (local_normal block c) in
      (Rat.sub q q', Rat.sub k k')
    in
    satisfied c.relation ~room:(List.fold_left take (Q.of_bigint c.right, Rat.zero) blocks)

let below relation bound =
  match (bound, (relation : Constraint.relation)) with
  | Unbounded, _ -> false
  | Bound { value; attained }, Less -> Rat.sign value < 0 || (Rat.sign value = 0 && not attained)
  | Bound { value; _ }, (At_most | Equal) -> Rat.sign value <= 0

let implies t (c : Constraint.t) =
  match blocks_in t c with
  | [] -> Constraint.truth c = Some true
  | [ block ] -> Tableau.implies block.system (local block c)
  | _ :: _ :: _ ->
    satisfies t c
    &&
    let f = Constraint.to_form c in
    below c.relation (supremum t f)
    && (c.relation <> Equal || below Equal (supremum t (Linear.neg f)))

(* The block that has the constraint of this number, and which one of the block it is. *)
let home t number =
  let rec index numbers i =
    if i >= Array.length numbers then None else if numbers.(i) = number then Some i else index numbers (i + 1)
  in
  let look found block =
    match found with
    | Some _ -> found
    | None -> Option.map (fun i -> (block, i)) (index block.numbers 0)
  in
  fold_blocks look None t

let is_redundant t number =
  match home t number with
  | Some (block, k) -> Tableau.is_redundant block.system k
  | None -> true

(* The number stays with the block, since the others keep theirs. *)
let without t number =
  match home t number with
  | Some (block, k) -> with_block t { block with system = Tableau.without block.system k }
  | None -> t

(* {1 Points} *)

let point_of t of_system =
  let point = Array.make (dimension t) Rat.zero in
  let put () block =
    let values = of_system block.system in
    Array.iteri (fun k i -> point.(i) <- values.(k)) block.variables
  in
  fold_blocks put () t;
  point

let point t = point_of t Tableau.point
let closed_point t = point_of t Tableau.closed_point
