(* The laws Displacement, Rotation and Scaling, of what is concluded: a model and what is seen of it from elsewhere
   get the same verdicts, as well known, from explorations of the same size. *)

open Scc_exact
open Scc_semantics
open Scc_state_space
open Scc_verify
open Scc_zones
module Gen = QCheck2.Gen

let standard = Scc_engine.Standard.of_model

(** {1 What is concluded} *)

type concluded = {
  verdicts : string list;  (** what each is, and how it is known; no numbers that depend on where it ended *)
  closed : bool;  (** all was explored *)
  cut : bool;  (** the bound of states ended some exploration *)
  states : int;
  transitions : int;
}

let limit : Verdict.limit -> string = function
  | Depth _ -> "depth"
  | Time _ -> "time"
  | Instant _ -> "instant"
  | States _ | Draws _ -> "states"
  | Bits _ -> "bits"
  | Seconds _ -> "seconds"
  | Memory _ -> "memory"
  | Interrupted -> "interrupted"
  | Omission _ -> "omission"

let reason : Verdict.reason -> string = function
  | Truncated { limit = l; _ } | Unevaluated { limit = l; _ } -> limit l
  | Unexplored _ -> "unexplored"
  | Undefined _ -> "undefined"
  | Fault _ -> "fault"

let words list = String.concat ", " (List.sort_uniq String.compare list)

(* [unit] is what a value of 1 becomes. *)
let value ~unit : Scc_chance.Answer.t -> string = function
  | Exact x -> Rat.to_string (Rat.div x unit)
  | Within _ -> "an interval"
  | At_least _ -> "a lower bound"
  | Infinite -> "infinite"

let told ~time ~closed (o : Verdict.outcome) =
  let unit =
    match o.check.asked with
    | Expected (_, Time_until _, _) -> time
    | Expected (_, (Events_until _ | Value_at _), _) | Whether | How_likely _ -> Rat.one
  in
  let verdict =
    match o.verdict with
    | Holds { bounds; _ } ->
      "holds " ^ words (List.map (fun (t : Verdict.truncation) -> limit t.limit) bounds)
    | Violated _ -> "violated"
    | Measured { values; reasons; _ } ->
      let one (_, (m : Scc_ctl.Eval.measured)) = value ~unit m.least ^ " to " ^ value ~unit m.most in
      String.concat "; " (List.map one values) ^ " " ^ words (List.map reason reasons)
    | Depends _ -> "depends"
    | Undecided reasons -> "undecided: " ^ words (List.map reason reasons)
  in
  let rest : Verdict.rest -> string = function By _ -> "by a run without time" | Among _ -> "among such runs" in
  let in_units step = Rat.to_string (Rat.div step time) in
  let split = if closed then Option.map in_units o.scale.split_step else None in
  let over (v : Verdict.over) = if v.by_invariant then "by an invariant" else "over zones" in
  String.concat ", "
    ((verdict :: Option.to_list split) @ Option.to_list (Option.map over o.scale.over) @ List.map rest o.rests)

(* Whether a weak split was enabled somewhere is not known of what was not explored. *)
let concluded ~time (r : Check.report) =
  let closed = r.stats.complete && not r.stats.decided_early in
  {
    verdicts = List.map (told ~time ~closed) r.outcomes;
    closed;
    cut = List.exists (fun (t : Verdict.truncation) -> limit t.limit = "states") r.stats.stopped_by;
    states = r.stats.states;
    transitions = r.stats.transitions;
  }

type how = { states : int; until : Rat.t option; reductions : Reduction.kind list; prove : bool }

let checked how ({ model; declared; uncertain; checks } : Seen.model) ~time =
  let bounds =
    {
      Bounds.default with
      states = Default how.states;
      time = (match how.until with Some t -> Given (Rat.mul time t) | None -> Unbounded);
      instant = Default 60;
    }
  in
  let options = { Setup.default with bounds; reductions = how.reductions; prove = how.prove } in
  let semantics = standard model in
  let forms () = match uncertain with Some u -> u | None -> Scc_symbolic.Start.known model declared in
  if Zone_check.is_for model ~declared then
    match Zone_check.run options semantics (forms ()) ~declared ~exactly:false ~premises:[] checks with
    | Ok r -> Some (concluded ~time r)
    | Error _ -> None
  else
    match Network.initial semantics declared with
    | Error _ -> None
    | Ok initial when how.prove && Zone_check.refused model Invariants = [] ->
      let decided, _ = By_invariant.decide options Longer semantics (forms ()) ~declared checks in
      Some (concluded ~time (Check.run_without options semantics ~initial checks ~decided))
    | Ok initial -> Some (concluded ~time (Check.run options semantics ~initial checks))

(** {1 The comparison} *)

let describe c =
  Printf.sprintf "%s, %d states, %d transitions: %s"
    (if c.closed then "closed" else "open")
    c.states c.transitions (String.concat " | " c.verdicts)

(* How an image is explored: where reductions look at boxes along the axes it may have more states. *)
type sizes = Same | Up_to_times of int

(* Where that bound cut both, what was found first counts; where all was decided early, how many there were by then
   does not. *)
let differ ~sizes a b =
  match sizes with
  | Same when a.cut && b.cut -> false
  | Same ->
    let sizes c = if c.closed then Some (c.states, c.transitions) else None in
    a.cut <> b.cut || a.verdicts <> b.verdicts || sizes a <> sizes b
  | Up_to_times _ -> (not a.cut) && (b.cut || a.verdicts <> b.verdicts)

let compared how ~sizes (m : Seen.model) (view : Seen.t) =
  let more = match sizes with Same -> how | Up_to_times n -> { how with states = n * how.states } in
  match (checked how m ~time:Rat.one, checked more (view.see m) ~time:view.time) with
  | None, None -> None
  | Some a, Some b when not (differ ~sizes a b) -> None
  | Some a, Some b -> Some (Printf.sprintf "%s: %s; and then %s" view.name (describe a) (describe b))
  | Some _, None | None, Some _ -> Some (view.name ^ ": one is refused")

let all = { states = 2000; until = None; reductions = Reduction.all; prove = false }

(** {1 By hand: files} *)

let pythagorean = Quaternion.make Z.(of_int 2) Z.one Z.zero Z.zero
let about_z = Quaternion.make Z.(of_int 2) Z.zero Z.zero Z.one
let both = Quaternion.mul pythagorean about_z

let views =
  Seen.rotations
  @ [
    Seen.rotation pythagorean; Seen.rotation about_z; Seen.rotation both;
    Seen.displacement (Vec.of_ints 3 (-5) 100);
    Seen.units ~length:(Rat.of_int 2) ~time:(Rat.make Z.one (Z.of_int 2)) ~mass:(Rat.of_int 4); Seen.mirror;
  ]

let sweep how files =
  let one file =
    match Scc_test_models.Load.file file with
    | Error _ -> Printf.printf "%s: refused\n%!" file
    | Ok e ->
      let m = Seen.of_elaborated e in
      (match checked how m ~time:Rat.one with
       | Some c -> Printf.printf "%s: %s\n%!" file (describe c)
       | None -> ());
      List.iter
        (fun view ->
           match compared how ~sizes:Same m view with
           | None -> ()
           | Some why -> Printf.printf "  DIFFERS %s\n%!" why
           | exception e -> Printf.printf "  RAISED %s: %s\n%!" view.Seen.name (Printexc.to_string e))
        views
  in
  List.iter one files

(** {1 At random} *)

let print (text, view) = text ^ "\nseen by " ^ view.Seen.name

let mentions word text =
  let n = String.length word in
  let rec from i = i + n <= String.length text && (String.equal word (String.sub text i n) || from (i + 1)) in
  from 0

(* Slice and Order look at boxes along the axes of the world, and take away states of what is explored to its end
   anyway; rule Drift sees distances within cubes; how many states lie between draws is a matter of their order. *)
let sizes how text (view : Seen.t) =
  let uses kind = List.exists (Reduction.equal kind) how.reductions in
  let boxes = uses Slice || uses Order || mentions "distance2" text in
  if mentions "chance" text || mentions "choose" text || (boxes && not view.right) then Up_to_times 8 else Same

let agree name ?(count = 40) cases how =
  QCheck2.Test.make ~name ~count ~print (Gen.pair cases Seen.any) (fun (text, view) ->
      match Scc_test_models.Load.text text with
      | Error _ -> true
      | Ok e -> (
          match compared how ~sizes:(sizes how text view) (Seen.of_elaborated e) view with
          | None -> true
          | Some why -> QCheck2.Test.fail_report why))

let () =
  match Array.to_list Sys.argv with
  | _ :: "--sweep" :: states :: files -> sweep { all with states = int_of_string states } files
  | _ :: "--prove" :: states :: files -> sweep { all with states = int_of_string states; prove = true } files
  | _ ->
    let how = { all with states = 300 } in
    let without_boxes = { how with reductions = [ Symmetry; Translation; Jump; Drift; Time ] } in
    Alcotest.run "conclusions"
      [
        ( "conclusions",
          Scc_test_support.Property.cases
            [
              agree "Rotation: what drifts apart" Drifters.case how;
              agree "Rotation: and how many states there are" Drifters.case without_boxes;
              agree "Rotation: crowds" Crowds.case_gen how;
              agree "Rotation: rings" ~count:8 Crowds.ringed_case_gen how;
            ] );
      ]
