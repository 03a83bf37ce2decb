open Scc_base
open Scc_data
open Scc_exact
open Scc_broad_phase
open Scc_calculus

let reported_overlaps = 10

(* The bodies of the network, by index in the model; those with faults are left out. *)
let included (bodies : Bodies.t) (composition : Composition.t) =
  Array.to_list bodies.leaves
  |> List.mapi (fun i leaf -> (i, leaf))
  |> List.filter (fun (i, _) -> composition.included.(i))
  |> List.filter_map snd

let placed (l : Bodies.leaf) body =
  let place (p : Model.part) = { Overlap.body; solid = p.solid; position = Vec.add l.position p.offset } in
  Array.to_list (Array.map place l.parts)

let check_overlaps (c : Context.t) bodies composition =
  let known (p : Model.part) = Option.is_none p.open_offset in
  let stands (l : Bodies.leaf) = Option.is_some (Form.fixed l.place) && Array.for_all known l.parts in
  let leaves = Array.of_list (List.filter stands (included bodies composition)) in
  let parts = List.mapi (fun body l -> placed l body) (Array.to_list leaves) in
  let parts = Array.of_list (List.concat parts) in
  let report (i, j) =
    let p = leaves.(parts.(i).body) and q = leaves.(parts.(j).body) in
    let where =
      match Overlap.common_point parts.(i) parts.(j) with
      | Some x -> Printf.sprintf ": the point %s is inside both" (Vec.to_string x)
      | None -> ""
    in
    Report.error c.report Code.interpenetration q.span "`%s` and `%s` interpenetrate%s" p.name q.name where
      ~notes:[ (p.span, Printf.sprintf "`%s` is here" p.name) ]
  in
  List.iter report (Overlap.pairs ~limit:reported_overlaps c.obstacles parts)

let sound = function
  | Some leaf -> leaf
  | None -> Bug.fail __POS__ "a body with faults"

let numbered (bodies : Bodies.t) (composition : Composition.t) =
  List.filter (fun i -> composition.included.(i)) (List.init (Array.length bodies.leaves) Fun.id)
  |> List.map (fun i -> (i, sound bodies.leaves.(i)))

let leaves bodies (composition : Composition.t) =
  let leaf (i, (l : Bodies.leaf)) =
    let law, law_at = composition.laws.(i) in
    {
      Model.name = l.name;
      template = Shape.label l.shape;
      parts = l.parts;
      fixed = l.fixed;
      absorbs = l.absorbs;
      mass = l.mass;
      law;
      law_at;
    }
  in
  Array.of_list (List.map leaf (numbered bodies composition))

let uncertain bodies composition ranges : Uncertain.t option =
  let n = Array.length ranges in
  let forms (x, y, z) = (Form.linear n x, Form.linear n y, Form.linear n z) in
  let members = List.map snd (numbered bodies composition) in
  let glues i (l : Bodies.leaf) =
    match l.shape with
    | Basic _ -> []
    | Compound compound ->
      List.map (fun (g : Shape.glue) -> { Uncertain.leaf = i; one = g.one; two = g.two }) compound.open_glues
  in
  if n = 0 then None
  else
    Some
      {
        places = Array.of_list (List.map (fun (l : Bodies.leaf) -> forms l.place) members);
        glues = List.concat (List.mapi glues members);
      }

let bond (composition : Composition.t) (j : Joints.t) =
  let finish (i, site) = { State.at = composition.index.(i); site } in
  State.bond j.name (finish j.one) (finish j.two)

let spinning bodies (composition : Composition.t) =
  let spins (i, (l : Bodies.leaf)) =
    let law, law_at = composition.laws.(i) in
    if not (Vec.is_zero l.spin) then Some (Printf.sprintf "`%s` spins" l.name, l.span)
    else if Law.gives_spin law then Some (Printf.sprintf "a law of motion gives `%s` a spin" l.name, law_at)
    else None
  in
  List.find_map spins (numbered bodies composition)

(* The processes are the connected components of the bonds. The velocity of a leaf is that of its own centroid,
   and of a process that of its centre of mass. *)
let state bodies (composition : Composition.t) joints behaviours (model : Model.t) =
  let members = Array.of_list (numbered bodies composition) in
  let n = Array.length members in
  let joined = Union_find.create n in
  let bonds = List.map (bond composition) joints in
  List.iter (fun (b : State.bond) -> ignore (Union_find.union joined b.one.at b.two.at)) bonds;
  let leaves_of = Array.make n [] and bonds_of = Array.make n [] in
  let put table root x = table.(root) <- x :: table.(root) in
  Array.iteri
    (fun i (_, (l : Bodies.leaf)) ->
       put leaves_of (Union_find.find joined i)
         {
           State.leaf = i;
           position = l.position;
           turned = Quaternion.identity;
           waited = Rat.zero;
           behaviour = Behaviour.fresh behaviours.(i);
         })
    members;
  List.iter (fun (b : State.bond) -> put bonds_of (Union_find.find joined b.one.at) b) bonds;
  let turning p (l : Bodies.leaf) =
    let arm = Vec.sub (State.centre_of_mass model p) (Bodies.centroid l) in
    State.with_turn ~spin:l.spin ~since:Rat.zero ~lasts:None p
    |> State.with_velocity (Vec.add l.velocity (Vec.cross l.spin arm))
  in
  let process root =
    match leaves_of.(root) with
    | [] -> None
    | leaves ->
      let _, (l : Bodies.leaf) = members.(root) in
      let still = State.process ~leaves ~bonds:bonds_of.(root) ~velocity:l.velocity ~clock:None () in
      Some (if Vec.is_zero l.spin then still else turning still l)
  in
  State.make
    ~processes:(List.filter_map process (List.init n Fun.id))
    ~step:(if Model.of_all model then Some { State.remaining = model.timestep; phase = Due } else None)
    ~time:(if model.keeps_time then Some Rat.zero else None)
