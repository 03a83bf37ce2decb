open Scc_calculus

type collision = (Transition.outcome list, Transition.fault) result

type t = {
  parts : int -> State.process -> (unit -> Part.t list) -> Part.t list;
  urgent : State.process -> (unit -> Transition.outcome list) -> Transition.outcome list;
  weak : State.process -> (unit -> Transition.outcome list) -> Transition.outcome list;
  contact : Part.t -> Part.t -> (unit -> Kinematics.contact) -> Kinematics.contact;
  collision : State.process -> State.process -> (unit -> collision) -> collision;
  renewed : unit -> t;
}

let rec none =
  {
    parts = (fun _ _ answer -> answer ());
    urgent = (fun _ answer -> answer ());
    weak = (fun _ answer -> answer ());
    contact = (fun _ _ answer -> answer ());
    collision = (fun _ _ answer -> answer ());
    renewed = (fun () -> none);
  }
