open Scc_data
open Scc_exact
open Scc_calculus
open Scc_semantics

module Vectors = Numbering.Make (Vec)

module Forms = Numbering.Make (struct
    type t = State.process

    let equal = State.equal_process
    let hash = State.hash_process
  end)

let hash_label : Transition.label -> int = function
  | Time d -> Rat.hash d
  | Bind b -> 1 + State.hash_bond b
  | Close b -> 2 + State.hash_bond b
  | (Weak_split _ | Strong_split _) as l ->
    List.fold_left (fun h b -> (31 * h) + State.hash_bond b) 3 (Transition.bonds l) land max_int
  | Absorb { first; absorber } -> 7 + (31 * first) + absorber
  | Lot { bond; chance; _ } -> 13 + (31 * State.hash_bond bond) + Rat.hash chance
  | Draw { first; given; _ } -> 11 + (31 * first) + Given.hash given
  | Bounce { firsts; _ } -> List.fold_left (fun h p -> (1_000_003 * h) + p) 5 firsts land max_int

type joint = { chance : Rat.t; transitions : int }
type label = One of Transition.label | Tied of Transition.label * Rat.t | Joint of joint

module Label_key = struct
  type t = label

  let equal a b =
    match (a, b) with
    | One a, One b -> Transition.equal_label a b
    | Tied (a, p), Tied (b, q) -> Rat.equal p q && Transition.equal_label a b
    | Joint a, Joint b -> a.transitions = b.transitions && Rat.equal a.chance b.chance
    | (One _ | Tied _ | Joint _), _ -> false

  let hash = function
    | One l -> hash_label l
    | Tied (l, chance) -> (31 * Rat.hash chance) + hash_label l
    | Joint j -> (31 * Rat.hash j.chance) + j.transitions
end

module Labels = Numbering.Make (Label_key)

module Step_key = struct
  type t = State.step

  let equal (a : t) (b : t) =
    Rat.equal a.remaining b.remaining && a.phase = b.phase

  let hash (s : t) = Rat.hash s.remaining
end

module Steps = Numbering.Make (Step_key)
