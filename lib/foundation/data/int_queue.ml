let span = 1024

(* Blocks of [span] numbers: those at the head have been taken, and those at the end of the last are still to
   come. *)
type t = { blocks : int array Queue.t; mutable last : int array; mutable first : int; mutable length : int }

let create () = { blocks = Queue.create (); last = [||]; first = 0; length = 0 }
let length q = q.length

let push q x =
  let at = (q.first + q.length) mod span in
  if at = 0 || Queue.is_empty q.blocks then begin
    q.last <- Array.make span 0;
    Queue.push q.last q.blocks
  end;
  q.last.(at) <- x;
  q.length <- q.length + 1

let take q =
  if q.length = 0 then None
  else begin
    let x = (Queue.peek q.blocks).(q.first) in
    q.length <- q.length - 1;
    q.first <- q.first + 1;
    if q.first = span then begin
      ignore (Queue.pop q.blocks);
      q.first <- 0
    end;
    Some x
  end
