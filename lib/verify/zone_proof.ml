open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_symbolic

type t = { invariant : Invariant.t; proofs : Proof.t list }
type end_ = Proved of t | None_found of string

(* Who did not ask for it waits less long. *)
let limits (options : Joint_check.options) =
  if options.prove then { Invariant_search.locations = 2_000; steps = 50_000 }
  else { locations = 200; steps = 1_000 }

let no_time = None_found "there was too little time to look for one"

let distinct events =
  let add kept e = if List.exists (Formula.equal_event e) kept then kept else e :: kept in
  List.rev (List.fold_left add [] events)

let search (options : Joint_check.options) semantics u ~declared ~parameters zones formulas =
  let context = Instant.context semantics in
  let events = Array.of_list (distinct (List.concat_map Formula.events formulas)) in
  let over = if options.prove then options.surroundings.half () else options.surroundings.stop in
  let stop () = Option.is_some (over ()) in
  let looked_at ~locations ~waiting =
    options.surroundings.progress
      { states = locations; transitions = 0; waiting; depth = 0; model_time = Rat.zero }
  in
  match Invariant_search.find context ~events ~limits:(limits options) ~visitor:{ stop; looked_at } zones with
  | Stopped -> no_time
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
          | Error reason -> None_found ("a set of states was found, but its proof is not accepted: " ^ reason)))

let initial semantics declared =
  match Network.initial semantics declared with
  | Ok s -> s
  | Error _ -> Scc_base.Bug.fail __POS__ "a law of motion in a model with ranges"

let attempt options semantics u ~declared (checks : Property.check list) =
  match Scc_certificate.Certificate.not_for (Semantics.model semantics) with
  | Some reason -> Ok (None_found reason)
  | None ->
    let initial = initial semantics declared in
    let formulas = List.map (fun (c : Property.check) -> c.formula) checks in
    let parameters = Ranges.box (Semantics.model semantics).ranges in
    Start.zones (Instant.context semantics) u ~initial ~keeps_time:false
    |> Result.map (fun zones ->
        let run () = search options semantics u ~declared ~parameters zones formulas in
        Result.value (options.surroundings.attempt.run Concluding run) ~default:no_time)

let decided semantics ~declared (check : Property.check) (proof : Proof.t) =
  let outcome verdict =
    let scale = Zone_scale.make semantics ~declared ~example:[] ~by_invariant:true in
    Some { Verdict.check; verdict; scale; rests = []; converges = None; lost = [] }
  in
  if not (Union.is_empty proof.sets.holds) then outcome (Holds { bounds = []; witness = None })
  else if not (Union.is_empty proof.sets.fails) then outcome (Violated { witness = None })
  else None

let prove options semantics u ~declared checks =
  match attempt options semantics u ~declared checks with
  | Error _ -> ((fun _ -> None), None_found "the declared state is not well-formed")
  | Ok (None_found _ as end_) -> ((fun _ -> None), end_)
  | Ok (Proved { proofs; _ } as end_) ->
    let all = List.combine checks (List.map2 (decided semantics ~declared) checks proofs) in
    ((fun check -> Option.join (List.assq_opt check all)), end_)
