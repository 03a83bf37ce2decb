open Scc_exact
open Scc_property
open Scc_json
open Scc_runs
open Json_format

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

(* {1 What names stand for} *)

let name_format =
  form
    [
      { set = "A-Za-z"; least = 1; most = Some 1 }; { set = "A-Za-z0-9_"; least = 0; most = Some 63 };
    ]
  |> about "For tools that take letters, digits and underscores only." |> named ~file:"names" "name"

let named_texts =
  list (fields [ field "name" name_format fst; field "text" text snd ]) |> checked |> named ~file:"names" "named"

type names = { exported : Exported.t; mdp : Mdp.t; variables : State_variables.t }

let check_format =
  let asked (n, (c : Property.check)) =
    let occurs = Mdp.occurs n.mdp and draws = Scc_calculus.Model.decides_by_chance n.exported.loaded.model in
    Result.to_option (Pctl.check ~occurs ~draws (Labelling.predicates (Mdp.labelling n.mdp)) c)
  in
  fields
    [
      field "name" text (fun (_, (c : Property.check)) -> c.name);
      field "text" text (fun (_, (c : Property.check)) -> c.text);
      field "formula" (nullable text) asked
        ~about:"What to ask PRISM or Storm; null for what labels alone do not tell.";
    ]

let names_format =
  let labels n =
    let label (p : State_predicates.t) = (p.name, p.text) in
    List.map label (Array.to_list (Labelling.predicates (Mdp.labelling n.mdp)))
  in
  let notes n = Exported.summary n.exported @ Exported.label_notes (Mdp.labelling n.mdp) in
  let variable =
    fields
      [
        field "name" name_format fst;
        field "values" Shared.texts snd
          ~about:"What the values from 0 on stand for; none for counts and for the number of the state.";
      ]
  in
  fields
    (Shared.head "scc-names" 1
     @ [
       within (fun n -> n.exported.loaded.origin) Origin_json.fields;
       field "notes" Shared.texts notes
         ~about:"How much was explored, and which labels do not tell all, in words.";
       field "checks" (list check_format) (fun n -> List.map (fun c -> (n, c)) n.exported.loaded.checks);
       field "labels" named_texts labels;
       field "actions" named_texts (fun n -> Mdp.actions n.mdp);
       field "variables" (list variable) (fun n -> State_variables.meanings n.variables)
         ~about:"Of the file of states.";
     ])

let names exported mdp variables put = put (Json.pretty (write names_format { exported; mdp; variables }))
