type t = {
  most : int;
  chunk : Bytes.t;
  mutable at : int;  (** what is left of the chunk *)
  mutable stop : int;
  mutable over : bool;
  line : Buffer.t;  (** what has been read of the present line *)
  mutable skipping : bool;  (** it is too long *)
}

type line = Line of string | Too_long | End

let size = 65536

let make ~most =
  {
    most;
    chunk = Bytes.create size;
    at = 0;
    stop = 0;
    over = false;
    line = Buffer.create 4096;
    skipping = false;
  }

let fill t =
  match Scc_system.Reading.input t.chunk 0 size with
  | 0 -> t.over <- true
  | n ->
    t.at <- 0;
    t.stop <- n

let keep t from stop =
  if not t.skipping then
    if Buffer.length t.line + (stop - from) > t.most then begin
      t.skipping <- true;
      Buffer.reset t.line
    end
    else Buffer.add_subbytes t.line t.chunk from (stop - from)

let finish t =
  if t.skipping then begin
    t.skipping <- false;
    Too_long
  end
  else begin
    let text = Buffer.contents t.line in
    if Buffer.length t.line > 16 * size then Buffer.reset t.line else Buffer.clear t.line;
    Line text
  end

let rec next t ~wait =
  if t.at < t.stop then begin
    let from = t.at in
    match Bytes.index_from_opt t.chunk from '\n' with
    | Some i when i < t.stop ->
      keep t from i;
      t.at <- i + 1;
      finish t
    | Some _ | None ->
      keep t from t.stop;
      t.at <- t.stop;
      next t ~wait
  end
  else if t.over then if t.skipping || Buffer.length t.line > 0 then finish t else End
  else begin
    wait ();
    fill t;
    next t ~wait
  end
