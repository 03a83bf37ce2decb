open Scc_exact

type value = Finite of Linear.t | Infinite | Unknown

module Value = struct
  type t = value

  let equal a b =
    match (a, b) with
    | Finite f, Finite g -> Linear.equal f g
    | Infinite, Infinite | Unknown, Unknown -> true
    | (Finite _ | Infinite | Unknown), _ -> false

  let hash = function Finite f -> Linear.hash f | Infinite -> 1 | Unknown -> 2
  let any = Unknown

  let compose v ~dimension forms =
    match v with
    | Finite f -> Finite (Linear.compose f ~dimension forms)
    | Infinite | Unknown -> v
end

include (Diagram.Make (Value) : Diagram.S with type value := value)

let add_values a b =
  match (a, b) with
  | Unknown, _ | _, Unknown -> Unknown
  | Infinite, _ | _, Infinite -> Infinite
  | Finite f, Finite g -> Finite (Linear.add f g)

let add s = combine s Add (fun v w -> match (v, w) with Some v, Some w -> Some (add_values v w) | _ -> None)
let plus s form = map s (add_values (Finite form))

let times k = function Finite f -> Finite (Linear.scale k f) | (Infinite | Unknown) as v -> v

let sum s ~dimension terms =
  let zero = constant s (Finite (Linear.constant dimension Rat.zero)) in
  let some (k, _) = Rat.sign k > 0 in
  List.fold_left (fun all (k, f) -> add s all (map s (times k) f)) zero (List.filter some terms)

(* The one that [first] has where the constraint holds; an unknown value is unknown beside any other. *)
let better ~of_infinite v w : value Diagram.cut =
  match (v, w) with
  | v, None | None, v -> One v
  | Some Unknown, _ | _, Some Unknown -> One (Some Unknown)
  | Some Infinite, Some v | Some v, Some Infinite -> One (Some (of_infinite v))
  | Some (Finite f), Some (Finite g) ->
    if Linear.equal f g then One v else Cut (Constraint.at_most f g, Finite f, Finite g)

let swapped : value Diagram.cut -> value Diagram.cut = function
  | Cut (c, yes, no) -> Cut (c, no, yes)
  | One _ as one -> one

let least s = combine_cutting s Least (better ~of_infinite:Fun.id)
let greatest s = combine_cutting s Greatest (fun v w -> swapped (better ~of_infinite:(fun _ -> Infinite) v w))
