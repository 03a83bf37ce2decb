open Scc_exact
open Scc_property

(* A comment is a line. *)
let comment write text =
  write ("// " ^ String.map (function '\n' | '\r' -> ' ' | c -> c) text ^ "\n")

let no_time_passes mdp =
  let instant i = List.for_all (fun (c : Mdp.choice) -> Rat.sign c.duration = 0) (Mdp.choices mdp i) in
  let rec from i = i = Mdp.states mdp || (instant i && from (i + 1)) in
  from 0

let write (e : Exported.t) mdp put =
  let line fmt = Printf.ksprintf (fun s -> put (s ^ "\n")) fmt in
  let l = Mdp.labelling mdp in
  (* The format has no declarations, and Storm does not know labels that hold nowhere. *)
  let occurs = Mdp.occurs mdp and draws = Scc_calculus.Model.decides_by_chance e.loaded.model in
  List.iter (comment put) (Exported.summary e);
  List.iter (comment put) (Exported.label_notes l);
  Array.iter
    (fun (p : State_predicates.t) -> comment put (Printf.sprintf "label %s: %s" p.name p.text))
    (Labelling.predicates l);
  List.iter (fun (name, text) -> comment put (Printf.sprintf "action %s: %s" name text)) (Mdp.actions mdp);
  List.iter
    (fun (c : Property.check) ->
       let asked =
         match Pctl.check ~occurs ~draws (Labelling.predicates l) c with
         | Ok f -> f
         | Error why -> "is not asked for by labels alone: " ^ why
       in
       comment put (Printf.sprintf "check %s: %s" c.name asked))
    e.loaded.checks;
  (* Storm refuses questions about a reward model whose rewards are all 0. *)
  let extra = no_time_passes mdp and states = Mdp.states mdp in
  let and_extra n = if extra then n + 1 else n in
  if extra then
    comment put
      (Printf.sprintf "state %d: not reached; it has a reward since no action of the others takes time" states);
  line "@type: MDP";
  line "@value_type: rational";
  line "@parameters";
  line "";
  line "@reward_models";
  line "time";
  line "@nr_states";
  line "%d" (and_extra states);
  line "@nr_choices";
  line "%d" (and_extra (Mdp.count mdp));
  line "@model";
  for i = 0 to states - 1 do
    line "state %d [0]%s" i (String.concat "" (List.map (fun s -> " " ^ s) (Mdp.labels mdp i)));
    List.iter
      (fun (c : Mdp.choice) ->
         line "\taction %s [%s]" c.action (Rat.to_string c.duration);
         List.iter (fun (target, chance) -> line "\t\t%d : %s" target (Rat.to_string chance)) c.targets)
      (Mdp.choices mdp i)
  done;
  if extra then line "state %d [0]\n\taction unreachable [1]\n\t\t%d : 1" states states
