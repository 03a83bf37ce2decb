open Scc_exact
module Times = Map.Make (Rat)

(* The numbers from [first] to [last]. States mostly come in by increasing numbers, each next to the one before. *)
type run = { mutable first : int; mutable last : int }

type t =
  | Line of { runs : run Queue.t; mutable newest : run; mutable length : int }
  | Calendar of { mutable days : int Queue.t Times.t; mutable length : int }

let by_steps () = Line { runs = Queue.create (); newest = { first = 0; last = -1 }; length = 0 }
let by_time () = Calendar { days = Times.empty; length = 0 }

let push f i time =
  match f with
  | Line l ->
    l.length <- l.length + 1;
    if l.newest.first <= l.newest.last && i = l.newest.last + 1 then l.newest.last <- i
    else begin
      l.newest <- { first = i; last = i };
      Queue.push l.newest l.runs
    end
  | Calendar c ->
    c.length <- c.length + 1;
    (match Times.find_opt time c.days with
     | Some day -> Queue.push i day
     | None ->
       let day = Queue.create () in
       Queue.push i day;
       c.days <- Times.add time day c.days)

let length = function Line { length; _ } | Calendar { length; _ } -> length

let take = function
  | Line l -> (
      match Queue.peek_opt l.runs with
      | None -> None
      | Some run ->
        let i = run.first in
        l.length <- l.length - 1;
        run.first <- i + 1;
        if run.first > run.last then ignore (Queue.pop l.runs);
        Some i)
  | Calendar c -> (
      match Times.min_binding_opt c.days with
      | None -> None
      | Some (time, day) ->
        let i = Queue.pop day in
        c.length <- c.length - 1;
        if Queue.is_empty day then c.days <- Times.remove time c.days;
        Some i)

let iter f = function
  | Line l -> Queue.iter (fun run -> for i = run.first to run.last do f i done) l.runs
  | Calendar c -> Times.iter (fun _ day -> Queue.iter f day) c.days
