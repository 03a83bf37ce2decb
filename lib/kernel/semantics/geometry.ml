open Scc_exact
open Scc_geometry
open Scc_rigid

type paths = { contact : Obstacle.cast; sweeps_meet : bool Lazy.t }

type t = {
  relation : Placed.t -> Placed.t -> Obstacle.relation;
  approaching : Placed.t -> Placed.t -> Vec.t -> bool;
  first_time_of_contact : Placed.t -> Placed.t -> Vec.t -> Obstacle.cast;
  meeting : Placed.t -> Placed.t -> Vec.t -> (Rat.t option * Rat.t option) option;
  touching : Placed.t -> Placed.t -> Contact.pair list;
  directions : (Placed.t * Placed.t) list -> Vec.t -> Vec.t list;
  paths : Placed.t -> Placed.t -> span:Rat.t -> Vec.t -> Vec.t -> paths;
  first_meeting : Vec.t list -> Vec.t list -> Vec.t -> Rat.t option;
  first_penetration : Motion.t -> Motion.t -> span:Rat.t -> grid:int -> phase:Rat.t -> Cast.outcome;
  near : resolution:Rat.t -> Placed.t -> Placed.t -> Near_contact.t option;
}

let exact ~obstacle:remembered =
  (* What has turned is a solid of its own, which nobody else asks for: its obstacles are not to be remembered. *)
  let obstacle (a : Placed.t) (b : Placed.t) =
    if Quaternion.is_identity a.turned && Quaternion.is_identity b.turned then remembered a.solid b.solid
    else Obstacle.make (Placed.fixed_solid a) (Placed.fixed_solid b)
  in
  let offset (a : Placed.t) (b : Placed.t) = Vec.sub b.at a.at in
  {
    relation = (fun a b -> Obstacle.relation (obstacle a b) (offset a b));
    approaching = (fun a b w -> Obstacle.approaching (obstacle a b) (offset a b) w);
    first_time_of_contact = (fun a b w -> Obstacle.first_time_of_contact (obstacle a b) (offset a b) w);
    meeting = (fun a b w -> Obstacle.meeting (obstacle a b) (offset a b) w);
    touching = (fun a b -> Contact.touching (obstacle a b) (offset a b));
    directions =
      (fun pairs w ->
         let touching (a, b) = { Response.obstacle = obstacle a b; offset = offset a b } in
         Response.directions (List.map touching pairs) w);
    paths =
      (fun a b ~span v u ->
         let obstacle = obstacle a b and offset = offset a b in
         let path = Vec.scale span in
         {
           contact = Obstacle.first_time_of_contact obstacle offset (Vec.sub u v);
           sweeps_meet = lazy (Swept.meet obstacle offset (path v) (path u));
         });
    first_meeting = Feature_cast.first_meeting;
    first_penetration =
      (fun a b ~span ~grid ~phase ->
         let still (m : Motion.t) = Quaternion.is_identity m.turned && not (Motion.turns m) in
         let obstacle = if still a && still b then Some (remembered a.solid b.solid) else None in
         Cast.first_time_of_contact ?obstacle a b ~span ~grid ~phase);
    near = Near_contact.find;
  }
