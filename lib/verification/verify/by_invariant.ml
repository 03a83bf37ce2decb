open Scc_polyhedra
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_graph_search
open Scc_state_sets
open Scc_symbolic
module Invariant = Scc_certificate.Invariant

type t = { invariant : Invariant.t; proofs : Proof.t list }
type end_ = Proved of t | None_found of string | Given_up of string
type effort = Briefly | Longer | Unasked

let least_states = 200_000

let states (options : Setup.t) =
  match options.bounds.states with
  | Given n | Default n -> Int.max least_states n
  | Unbounded -> least_states

let work options effort =
  states options * match effort with Briefly -> 50 | Longer -> 1000 | Unasked -> 250

(* A kind has the work of a hundred states. *)
let most_kinds options = function Briefly | Longer -> states options / 100 | Unasked -> 200

let stopped : Limits.stop -> _ = function
  | Seconds -> Given_up "there was too little time to look for one"
  | Memory -> Given_up "there was too little memory to look for one"
  | Interrupted -> Given_up "the search for one was interrupted"

(* After a brief search comes a longer one, where there is any need of it. *)
let more options = function
  | Briefly -> ""
  | Unasked -> "; --prove looks longer"
  | Longer -> Printf.sprintf "; --states %d allows twice as many" (2 * states options)

let too_much options effort =
  let millions = work options effort / 1_000_000 in
  Given_up
    (Printf.sprintf "the search for one was given up after %d million steps of arithmetic%s" millions
       (more options effort))

let leaving_time (options : Setup.t) before =
  match before with
  | Some (Given_up _) -> { options with surroundings = options.surroundings.half () }
  | Some (Proved _ | None_found _) | None -> options

let search (options : Setup.t) surroundings effort semantics u ~declared ~parameters zones formulas =
  let context = Instant.context semantics in
  let events = Scc_data.Lists.distinct Formula.equal_event (List.concat_map Formula.events formulas) in
  let events = Array.of_list events in
  let stop () = Option.is_some (surroundings.Limits.stop ()) in
  let looked_at ~locations ~waiting =
    surroundings.progress
      (Explored { states = locations; transitions = 0; waiting; depth = 0; model_time = Lazy.from_val None })
  in
  let most = most_kinds options effort in
  match Invariant_search.find context ~events ~most ~visitor:{ stop; looked_at } zones with
  | Stopped -> stopped (Option.value (surroundings.stop ()) ~default:Limits.Seconds)
  | No_end reason -> None_found reason
  | Found invariant -> (
      let atoms = Atoms.context context ~events in
      match Proof.views context invariant with
      | exception Instant.Not_affine reason -> None_found reason
      | views ->
        let proofs = List.map (Proof.make context atoms ~parameters views) formulas in
        let claims = List.concat_map (fun (p : Proof.t) -> p.claims) proofs in
        if claims = [] then None_found "no run leaves the set of states that was found, but this proves nothing"
        else (
          match Scc_certificate.Certificate.check semantics u ~declared invariant claims ~stop with
          | Ok () -> Proved { invariant; proofs }
          | Error reason -> (
              match surroundings.stop () with
              | Some stop -> stopped stop
              | None -> None_found ("a set of states was found, but its proof is not accepted: " ^ reason))))

let initial semantics declared =
  match Network.initial semantics declared with
  | Ok s -> s
  | Error _ -> Scc_base.Bug.fail __POS__ "a law of motion in a model with ranges"

let attempt (options : Setup.t) effort semantics u ~declared (checks : Property.check list) =
  match Scc_certificate.Certificate.not_for (Semantics.model semantics) with
  | Some reason -> Ok (None_found reason)
  | None when not (List.exists (fun (c : Property.check) -> Proof.may_prove c.formula) checks) ->
    Ok
      (None_found
         "an invariant proves no formula that nests operators of time, or that asks about time or quiescence")
  | None ->
    let initial = initial semantics declared in
    let formulas = List.map (fun (c : Property.check) -> c.formula) checks in
    let parameters = Ranges.box (Semantics.model semantics).ranges in
    Start.zones (Instant.context semantics) u ~initial ~keeps_time:false
    |> Result.map (fun zones ->
        let surroundings =
          match effort with
          | Briefly -> options.surroundings.half ()
          | Longer | Unasked -> options.surroundings
        in
        let search () = search options surroundings effort semantics u ~declared ~parameters zones formulas in
        let within () = Effort.within ~most:(work options effort) search in
        match surroundings.attempt.run Proving within with
        | Ok (Some end_) -> end_
        | Ok None -> too_much options effort
        | Error stop -> stopped stop)

let decided semantics ~declared (check : Property.check) (proof : Proof.t) =
  let outcome verdict =
    let scale = Left_open.make semantics ~declared ~example:[] ~everywhere:false ~by_invariant:true in
    Some { Verdict.check; verdict; scale; rests = []; converges = None; lost = []; left_out = None }
  in
  if not (Union.is_empty proof.sets.holds) then outcome (Holds { bounds = []; witness = None })
  else if not (Union.is_empty proof.sets.fails) then outcome (Violated { witness = None })
  else None

let decide options effort semantics u ~declared checks =
  match attempt options effort semantics u ~declared checks with
  | Error _ -> ((fun _ -> None), None_found "the declared state is not well-formed")
  | Ok ((None_found _ | Given_up _) as end_) -> ((fun _ -> None), end_)
  | Ok (Proved { proofs; _ } as end_) ->
    let all = List.combine checks (List.map2 (decided semantics ~declared) checks proofs) in
    ((fun check -> Option.join (List.assq_opt check all)), end_)
