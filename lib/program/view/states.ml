open Scc_data
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_json
open Scc_runs
open Json_format

type possible = { label : int; rules : Rule.t list; target : int option; chance : Rat.t option }

module Numbers = Hashtbl.Make (struct
    type t = State.t

    let equal = State.equal
    let hash = State.hash
  end)

type entry = {
  base : int option;
  later : Rat.t;
  gone : int list;
  come : int list;
  mutable values : Curve_json.t list;  (** none until it is known how long nothing happens *)
  mutable next : possible list option;
  mutable stuck : string option;
  mutable rests : bool;
  home : world;
  state : State.t Lazy.t;
}

and t = entry Growable.t

and world = {
  entries : t;
  tables : Tables.t;
  words : Model.t -> Transition.label -> string;
  plots : Property.num list;
  semantics : Semantics.t;
  numbers : int Numbers.t;
  bits : int;
}

let none = function [] -> true | _ :: _ -> false
let create () = Growable.create ()

let world ?(bits = max_int) entries tables ~words ~plots semantics =
  { entries; tables; words; plots; semantics; numbers = Numbers.create 64; bits }

let too_long w state = w.bits < max_int && (Length.longest state).bits > w.bits

let semantics w = w.semantics
let known w state = Numbers.find_opt w.numbers state
let label w l = Tables.label w.tables ~words:w.words w.semantics l

(* {1 What changes} *)

let same_leaf (a : State.leaf) (b : State.leaf) =
  Int.equal a.leaf b.leaf
  && Vec.equal a.position b.position
  && Quaternion.equal a.turned b.turned
  && Behaviour.equal_aged a.behaviour b.behaviour

let same_array equal a b = a == b || Scc_data.Arrays.equal equal a b

(* Whether a process is what another one has become by moving on alone, as it goes on itself: clocks are not
   told. *)
let goes_on m d (p : State.process) (q : State.process) =
  Vec.equal p.velocity q.velocity
  && Vec.equal p.spin q.spin
  && same_array State.equal_bond p.bonds q.bonds
  &&
  let still = Rat.sign d = 0 || (Vec.is_zero p.velocity && not (Turn.spinning p)) in
  ((not (Turn.spinning p)) || Rat.equal q.since (Rat.add p.since d))
  && same_array same_leaf (if still then p else Turn.pass m d p).leaves q.leaves

let first (p : State.process) = p.leaves.(0).leaf

(* Both are in the order of their first leaves. *)
let changes m d (before : State.t) (after : State.t) =
  let a = before.processes and b = after.processes in
  let rec from i j gone come =
    match (i < Array.length a, j < Array.length b) with
    | false, false -> (List.rev gone, List.rev come)
    | true, false -> from (i + 1) j (first a.(i) :: gone) come
    | false, true -> from i (j + 1) gone (b.(j) :: come)
    | true, true ->
      let order = Int.compare (first a.(i)) (first b.(j)) in
      if order < 0 then from (i + 1) j (first a.(i) :: gone) come
      else if order > 0 then from i (j + 1) gone (b.(j) :: come)
      else if goes_on m d a.(i) b.(j) then from (i + 1) (j + 1) gone come
      else from (i + 1) (j + 1) (first a.(i) :: gone) (b.(j) :: come)
  in
  from 0 0 [] []

(* {1 New states} *)

let entry home state base later ~gone ~come =
  { base; later; gone; come; values = []; next = None; stuck = None; rests = false; home; state }

let add w state entry =
  let n = Growable.length w.entries in
  Growable.push w.entries entry;
  Numbers.add w.numbers state n;
  n

let told w processes = List.map (Tables.process w.tables w.semantics) processes

let start w (state : State.t) =
  match known w state with
  | Some n -> n
  | None ->
    let come = told w (Array.to_list state.processes) in
    add w state (entry w (Lazy.from_val state) None Rat.zero ~gone:[] ~come)

let after w (before, state) d next =
  match known w next with
  | Some n -> n
  | None ->
    let gone, come = changes (Semantics.model w.semantics) d state next in
    add w next (entry w (Lazy.from_val next) (Some before) d ~gone ~come:(told w come))

let changed w before d ~gone ~come state =
  let n = Growable.length w.entries in
  Growable.push w.entries (entry w state (Some before) d ~gone ~come:(told w come));
  n

let set_values w n values =
  let e = Growable.get w.entries n in
  if none e.values then e.values <- values ()

let plots w = w.plots

let set_extent w n state extent =
  let e = Growable.get w.entries n in
  if none e.values then e.values <- List.map (Curves.value w.semantics state extent) w.plots

let set_next t n possible = (Growable.get t n).next <- Some possible

let home t n =
  let e = Growable.get t n in
  (e.home, Lazy.force e.state)

let has_next t n = Option.is_some (Growable.get t n).next
let set_stuck t n why = (Growable.get t n).stuck <- Some why
let set_rests t n = (Growable.get t n).rests <- true

let rest w n =
  set_next w.entries n [];
  set_rests w.entries n

let count = Growable.length

let next t n = (Growable.get t n).next

let told t n =
  match next t n with
  | None -> false
  | Some possible -> List.for_all (fun p -> Option.is_some p.target) possible

let all_told t =
  let rec from i = i = count t || (told t i && from (i + 1)) in
  from 0

(* {1 JSON} *)

let rules = from (List.map Rule.id) (list some_text)

let possible =
  fields
    [
      field "label" Rows.number (fun (p : possible) -> p.label);
      field "to" (nullable Rows.number) (fun p -> p.target) ~about:"null: where it leads is not in the document.";
      field "rules" rules (fun (p : possible) -> p.rules);
      maybe "chance" Shared.rational (fun p -> p.chance) ~about:"Its probability, where chance decides.";
    ]

let format =
  fields
    [
      field "of" (nullable Rows.number) (fun e -> e.base)
        ~about:"The state that this one is told by, an earlier one; null: by none, and all processes come.";
      field "after" Shared.rational (fun e -> e.later) ~about:"So much time after that one.";
      field "gone" (list Rows.number) (fun e -> e.gone)
        ~about:"The first leaves of processes of that one that are no more as they were.";
      field "come" (list Rows.number) (fun e -> e.come)
        ~about:"Processes that are there instead. All others have only moved on.";
      field "next" (nullable (list possible)) (fun e -> e.next)
        ~about:"What is possible, in the order of the choices; null: it was not looked at.";
      field "rests" bool (fun e -> e.rests) ~about:"Nothing will ever happen again.";
      field "stuck" (nullable text) (fun e -> e.stuck) ~about:"Why nothing can be said of what happens next.";
      maybe "values" (list Curve_json.format) (fun e -> if none e.values then None else Some e.values)
        ~about:"Of each plot, from there on, as long as nothing happens.";
    ]
  |> Rows.named "state"

let json t n = Json_format.write format (Growable.get t n)

let write t put =
  put "[";
  for i = 0 to count t - 1 do
    put (if i = 0 then "\n" else ",\n");
    put (Json.line (json t i))
  done;
  put "]"
