open Scc_exact
open Scc_property
open Scc_json
open Scc_runs

type dialect = Prism | Storm

let each mdp f =
  for i = 0 to Mdp.states mdp - 1 do
    f i
  done

(* Both programs read floats here. *)
let probability chance =
  if Rat.equal chance Rat.one then "1" else Scc_base.Float_text.shortest (Rat.to_float chance)

let transitions dialect mdp put =
  (match dialect with
   | Prism -> put (Printf.sprintf "%d %d %d\n" (Mdp.states mdp) (Mdp.count mdp) (Mdp.transitions mdp))
   | Storm -> put "mdp\n");
  each mdp (fun i ->
      List.iteri
        (fun k (c : Mdp.choice) ->
           List.iter
             (fun (target, chance) ->
                let action = match dialect with Prism -> " " ^ c.action | Storm -> "" in
                put (Printf.sprintf "%d %d %d %s%s\n" i k target (probability chance) action))
             c.targets)
        (Mdp.choices mdp i))

let declaration put names =
  put "#DECLARATION\n";
  put (String.concat " " names ^ "\n");
  put "#END\n"

let labels dialect mdp put =
  let names = Mdp.label_names mdp in
  match dialect with
  | Storm ->
    declaration put names;
    each mdp (fun i ->
        match Mdp.labels mdp i with
        | [] -> ()
        | held -> put (Printf.sprintf "%d %s\n" i (String.concat " " held)))
  | Prism ->
    let numbers = Hashtbl.create 64 in
    List.iteri (fun k name -> Hashtbl.replace numbers name (string_of_int k)) names;
    put (String.concat " " (List.mapi (fun k name -> Printf.sprintf "%d=\"%s\"" k name) names) ^ "\n");
    each mdp (fun i ->
        match Mdp.labels mdp i with
        | [] -> ()
        | held ->
          put (Printf.sprintf "%d: %s\n" i (String.concat " " (List.map (Hashtbl.find numbers) held))))

let used mdp =
  let seen = Hashtbl.create 64 in
  let found = ref [] in
  each mdp (fun i ->
      List.iter
        (fun (c : Mdp.choice) ->
           if not (Hashtbl.mem seen c.action) then begin
             Hashtbl.replace seen c.action ();
             found := c.action :: !found
           end)
        (Mdp.choices mdp i));
  List.rev !found

let choice_labels mdp put =
  declaration put (used mdp);
  each mdp (fun i ->
      List.iteri
        (fun k (c : Mdp.choice) -> put (Printf.sprintf "%d %d %s\n" i k c.action))
        (Mdp.choices mdp i))

let states mdp variables put =
  put (Printf.sprintf "(%s)\n" (String.concat "," (State_variables.names variables)));
  each mdp (fun i ->
      let state =
        match Labelling.stretch (Mdp.labelling mdp) i with None -> i | Some s -> s.source
      in
      (* A stretch has a number of its own, and is else like the state in which it began. *)
      let others = List.tl (State_variables.values variables state) in
      put (Printf.sprintf "%d:(%s)\n" i (String.concat "," (List.map string_of_int (i :: others)))))

let names (e : Exported.t) mdp variables put =
  let l = Mdp.labelling mdp in
  let texts list = `List (List.map Json.text list) in
  let label (p : State_predicates.t) = `Assoc [ ("name", Json.text p.name); ("text", Json.text p.text) ] in
  let action (name, text) = `Assoc [ ("name", Json.text name); ("text", Json.text text) ] in
  let occurs = Mdp.occurs mdp and draws = Scc_calculus.Model.leaves_to_chance e.loaded.model in
  let check (c : Property.check) =
    let asked = Pctl.check ~occurs ~draws (Labelling.predicates l) c in
    `Assoc
      [
        ("name", Json.text c.name);
        ("text", Json.text c.text);
        ("formula", Json.option Json.text (Result.to_option asked));
      ]
  in
  let variable (name, values) = `Assoc [ ("name", Json.text name); ("values", texts values) ] in
  put
    (Json.pretty
       (`Assoc
          ([ ("format", `String "scc-names"); ("version", `Int 1) ]
           @ Origin_json.members e.loaded.origin
           @ [
             ("notes", texts (Exported.summary e @ Exported.label_notes l));
             ("checks", `List (List.map check e.loaded.checks));
             ("labels", `List (List.map label (Array.to_list (Labelling.predicates l))));
             ("actions", `List (List.map action (Mdp.actions mdp)));
             ("variables", `List (List.map variable (State_variables.meanings variables)));
           ])))
