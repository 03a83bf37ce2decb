(* Invariants of random scenes against the ordinary rules at points of the parameters: all states that those reach
   are in them, nothing is reached that is claimed never to come, and the check of certificates, which knows
   nothing of how they were found, accepts them. *)

open Scc_ctl
open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_state_sets
open Scc_symbolic
module Invariant = Scc_certificate.Invariant
module Gen = QCheck2.Gen

type case = { scene : Scene.t; props : Property.prop list; seed : int }

let generate =
  let open Gen in
  let* scene = Scene.generate in
  let leaves = List.length scene.bodies in
  let one = Predicates.generate leaves ~timed:false in
  let+ props = flatten_l [ one 0; one 0; one 1; one 1 ] and+ seed = 0 -- 1_000_000 in
  { scene; props; seed }

let most = 40

(* As a hundred and fifty locations of such models take, or more. *)
let work = 20_000_000
let visitor = { Invariant_search.stop = (fun () -> false); looked_at = (fun ~locations:_ ~waiting:_ -> ()) }

let found = ref 0
let none = ref 0
let refused = ref 0
let states = ref 0
let claimed = ref 0
let denied = ref 0

let distinct events =
  let add kept e = if List.exists (Formula.equal_event e) kept then kept else e :: kept in
  Array.of_list (List.rev (List.fold_left add [] events))

let show_point p = String.concat ", " (List.map Rat.to_string (Array.to_list p))

let fail case p fmt =
  let fail why = QCheck2.Test.fail_reportf "at %s: %s (seed %d)" (show_point p) why case.seed in
  Printf.ksprintf fail fmt

let points (m : Model.t) =
  let one (r : Ranges.range) =
    let half = Rat.make Z.one (Z.of_int 2) in
    let middle = Rat.add r.low.value (Rat.mul half (Rat.sub r.high.value r.low.value)) in
    List.filter (Ranges.mem r) [ r.low.value; Rat.add r.low.value Rat.one; middle; r.high.value ]
    |> List.sort_uniq Rat.compare
  in
  let before rest v = List.map (fun p -> v :: p) rest in
  Array.fold_right (fun r rest -> List.concat_map (before rest) (one r)) m.ranges [ [] ] |> List.map Array.of_list

let some random n list =
  let a = Array.of_list list in
  let k = Array.length a in
  if k <= n then list else List.init n (fun _ -> a.(Random.State.int random k))

let horizon = Rat.of_int 6

let explore (s : Scene.t) ~events semantics initial =
  let until = if s.splits = Any then Some horizon else None in
  let go instants = Plain.explore semantics ~events ~horizon:until ~instants ~limit:300 initial in
  if s.splits = Any then
    let grid = List.init 7 Rat.of_int in
    go (List.sort_uniq Rat.compare (grid @ Plain.times (go grid)))
  else go []

let look case (m : Model.t) standard (invariant : Invariant.t) claims values =
  let s = case.scene in
  let semantics = Semantics.with_model standard (Scene.model_at s ~timed:(s.splits = Any) values) in
  match Network.initial semantics (Scene.declared_at s values) with
  | Error _ -> failwith "no initial state"
  | Ok initial ->
    let plain = explore s ~events:invariant.events semantics initial in
    let is (v : Plain.visit) (l : Invariant.location) =
      List.equal Int.equal l.arrived v.arrived && Replay.is_in m (Invariant.zone m l) values v.state
    in
    let visits = List.filter (fun (v : Plain.visit) -> not v.halted) plain.visits in
    let reached (v : Plain.visit) =
      incr states;
      if not (List.exists (is v) invariant.locations) then fail case values "a state is not in the invariant"
    in
    List.iter reached visits;
    let never (claim : Scc_certificate.Invariant.claim) =
      if Union.mem claim.values values then begin
        incr denied;
        let all =
          List.map (Plain.holds semantics ~events:invariant.events claim.never) visits
          @ List.concat_map (Plain.while_passing semantics claim.never) plain.passings
        in
        if List.exists (Truth.equal True) all then fail case values "what is claimed never to come is reached"
      end
    in
    List.iter never claims

let searched context ~events zones =
  let find () = Invariant_search.find context ~events ~most ~visitor zones in
  match Effort.within ~most:work find with Some end_ -> end_ | None -> No_end "too much work"

let agrees case =
  let s = { case.scene with timed = false; contact = false } in
  let case = { case with scene = s } in
  let m = Scene.model s in
  let standard = Scc_engine.Standard.of_model m in
  let context = Instant.context standard in
  let middle = Option.get (Polyhedron.interior_point (Ranges.box m.ranges)) in
  let declared = Scene.declared s middle in
  match Network.initial (Semantics.make { m with keeps_time = false }) declared with
  | Error _ -> failwith "no initial state"
  | Ok initial -> (
      match Start.zones context (Scene.uncertain s) ~initial ~keeps_time:false with
      | Error _ -> true
      | Ok zones -> (
          let events = distinct (List.concat_map (fun p -> Formula.events (State p)) case.props) in
          match searched context ~events zones with
          | Stopped -> failwith "nobody stops it"
          | No_end _ -> incr none; true
          | Found invariant ->
            incr found;
            let atoms = Atoms.context context ~events in
            let parameters = Ranges.box m.ranges in
            let views = Proof.views context invariant in
            let ever p = Property.Finally (Exists, { low = Rat.zero; high = None }, State p) in
            let of_prop p = (Proof.make context atoms ~parameters views (ever p)).claims in
            let claims = List.concat_map of_prop case.props in
            claimed := !claimed + List.length claims;
            let accepted =
              Scc_certificate.Certificate.check standard (Scene.uncertain s) ~declared invariant claims
                ~stop:(fun () -> false)
            in
            (match accepted with
             | Ok () -> ()
             | Error why ->
               incr refused;
               print_endline (Printf.sprintf "%s (seed %d)\n%s" why case.seed (Scene.print s)));
            let random = Random.State.make [| case.seed |] in
            List.iter (look case m standard invariant claims) (some random 5 (points m));
            true))

let generate = if Sys.getenv_opt "SCC_NO_SHRINKING" = None then generate else Gen.no_shrink generate

let law = QCheck2.Test.make ~name:"invariants" ~count:50 ~print:(fun c -> Scene.print c.scene) generate agrees

let enough () =
  Printf.printf "%d invariants (%d not accepted), %d without; %d states; %d claims, looked at %d times\n" !found
    !refused !none !states !claimed !denied;
  Alcotest.(check bool) "many" true (!found > 25 && !claimed > 30);
  Alcotest.(check bool) "nearly all are accepted" true (!refused * 50 <= !found)

let () =
  Alcotest.run "invariants"
    [ ("random", Scc_test_support.Property.cases [ law ] @ [ Alcotest.test_case "enough" `Quick enough ]) ]
