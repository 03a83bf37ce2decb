"""The commands of scc, as functions. Written by signatures.py from the manuals of scc; do not edit."""

from __future__ import annotations

from typing import Mapping, Optional, Sequence, Union

from . import _calls
from . import _source as words
from ._process import Progress
from ._source import Path, Setting, Source, Texts, Values
from .numbers import Number
from .results import Estimated, Simulated, Swept, Traced, Viewed
from .where import Checked


def check(
    model: Source,
    *,
    bits: Optional[int] = None,
    depth: Optional[int] = None,
    memory: Optional[int] = None,
    seconds: Optional[Number] = None,
    states: Optional[int] = None,
    time: Optional[Number] = None,
    axes: Optional[Texts] = None,
    check: Optional[Texts] = None,
    contrast: bool = False,
    coverage: bool = False,
    curve: Optional[str] = None,
    curve_plot: Optional[Path] = None,
    define: Optional[Mapping[str, Setting]] = None,
    draw: Optional[Path] = None,
    full: bool = False,
    hash_compact: bool = False,
    invariant: Optional[Path] = None,
    jobs: Optional[int] = None,
    no_reduce: Optional[Texts] = None,
    parametric: Optional[str] = None,
    prove: bool = False,
    sarif: Optional[Path] = None,
    shortest: Optional[str] = None,
    slice: Optional[Mapping[str, Number]] = None,
    smt: Optional[Path] = None,
    stats: bool = False,
    store: Optional[Path] = None,
    where: bool = False,
    witness: Optional[Path] = None,
    scc: Optional[str] = None,
    progress: Progress = None,
) -> Checked:
    """Explores a model and verifies its properties, as ``scc check`` does. Verdicts are no errors. Options:

    ``bits``: Expands only states whose numbers all have at most N bits, numerator and denominator together. The
      default is 100000.
    ``depth``: Expands only states that N or fewer transitions lead to. No default.
    ``memory``: Uses at most about N MiB of memory. The default is 3072. If the system limits this process
      (ulimit -v, ulimit -d), the default is no more than about half of what is left when the program has
      started.
    ``seconds``: Explores for at most S seconds of the clock. No default.
    ``states``: Keeps at most N states. The default is 200000.
    ``time``: Expands only states that can be reached by the model time T; 0 is the first instant. No default.
    ``axes``: The one or two parameters to --draw; by default the first ones.
    ``check``: Decides only the check NAME, as if the model had no others. May be given several times.
    ``contrast``: Shows with the run of a verdict another one, which does otherwise and parts from it as late as
      possible. So where a run never comes to what was to come, it shows one that does, and the step that
      decides. For checks with an operator about all runs or some run, at one start, but for possibly and always
      of predicates, which end early.
    ``coverage``: Lists the summands of behaviours that never fired, the behaviours that were never reached, and
      the channels and rules that were never used. It explores the whole model once more, even if all is
      decided, and counts during this exploration, within the same bounds; half of the seconds are kept for it.
      If a bound ends it, the report says how much was explored.
    ``curve``: Reports the probability that the check NAME asks for as a function of time. The check asks P = ?
      of an operator with a bound of time. A table lists all times up to the end of this bound at which the
      probability changes, and its value from there on. All of them come of one exploration.
    ``curve_plot``: Draws the curve of --curve as an SVG picture to FILE.
    ``define``: Gives the parameter NAME of the model the value VALUE, a rational. If the parameter has a range,
      it can be narrowed instead: to [1,3], or to [1,3), where a round bracket excludes an end. Repeatable.
    ``draw``: Like --where, but draws the sets to FILE, in SVG: the line of one parameter or the plane of two,
      divided into regions by the properties that hold there, and by the values of probabilities.
    ``full``: Prints runs in full: every step and every body, and numbers with all their digits; in JSON all
      steps of the way to an unexplored state. Without it long numbers are decimals: after ~ the nearest one
      with so many digits, with an error of at most half a unit of the last digit; without ~ the number itself.
    ``hash_compact``: Hash compaction: stores a fingerprint of each state instead of the state, which saves
      about 5 bytes a state. Two states with one fingerprint are taken for one, so that a search that finds
      nothing proves nothing. Such verdicts hold up to a bound, which names the probability that a state was
      left out. For always and possibly without a bound of time, their own or --time; other properties are
      checked as usual. Memory for the states of --states is reserved at once.
    ``invariant``: Like --prove, and writes the invariant on which a verdict rests to FILE: kinds of states,
      each with inequalities between its numbers. - is standard output.
    ``jobs``: The number of processes that explore. By default as many as there are cores, once that pays; with
      1 only this process. The report is the same for any number, to the byte, unless --seconds, --memory or an
      interruption ends the work: where that is depends on the time, and on the memory of all processes.
    ``no_reduce``: Switches reductions off: symmetry, translation, order, jump, slice, drift, time, draws,
      isometry, or all; separated by commas. No reduction changes a verdict; see REDUCTIONS.
    ``parametric``: Answers with functions of the parameter NAME, which the model declares with a range (param k
      in (0, 1)) and which stands in weights and chances alone. See PARAMETRIC.
    ``prove``: Searches for an invariant: a set of states that no run leaves. It may prove that something never
      happens where exploring does not end. The search is brief at first, and longer where a bound ended the
      exploration, all within the bounds. See PROOFS.
    ``sarif``: Writes errors, warnings, and the properties that are violated or undecided to FILE, as SARIF
      2.1.0. Editors and code reviews show them at their places. The steps of a witness are a code flow.
    ``shortest``: Which runs to show for possibly and always: those with the fewest steps, or the earliest in
      model time. The exploration proceeds in this order.
    ``slice``: Draws the regions at this value of a parameter that is not an axis. For other such parameters the
      drawing shows whether a property holds for all of their values, for some, or for none.
    ``smt``: Like --where, but writes the sets to FILE, as a script of SMT-LIB 2.6 that defines for each
      property where it holds, where it fails, and where that is unknown; and for a number its bounds.
    ``stats``: Prints what the run cost: seconds of each phase, states and transitions a second, memory. The
      phases are reading, exploring, searching for an invariant, and concluding: making verdicts and runs from
      the exploration. To standard error, or as measured in the JSON document. It varies from run to run.
    ``store``: Stores the exploration in the folder DIR, which is created if necessary, while it proceeds. After
      an interruption, the same command resumes, and ends with the report of a run that was never interrupted.
      See STORES.
    ``where``: For a model with ranges of parameters (param x in [0, 6]): prints for each property the values
      for which it holds, exactly, and the probability of these values, if they are independent and uniform in
      their ranges.
    ``witness``: Writes a schedule for each property that has a witness to the folder DIR, which is created if
      necessary: DIR/PROPERTY.json. scc trace --schedule replays it.

    ``scc``: the program; by default that of the environment variable SCC, or the one that this package carries,
    or the one on the PATH. ``progress``: True shows progress on standard error, and a function gets each line
    of it. The first Ctrl-C ends the command, and the result is what was there then (``interrupted``); the
    second is a KeyboardInterrupt. Raises CommandFailed.
    """
    given = [
        *words.integer("--bits", bits),
        *words.integer("--depth", depth),
        *words.integer("--memory", memory),
        *words.seconds("--seconds", seconds),
        *words.integer("--states", states),
        *words.number("--time", time),
        *words.listed("--axes", axes),
        *words.texts("--check", check),
        *words.flag("--contrast", contrast),
        *words.flag("--coverage", coverage),
        *words.text("--curve", curve),
        *words.path("--curve-plot", curve_plot),
        *words.define(model, define),
        *words.path("--draw", draw),
        *words.flag("--full", full),
        *words.flag("--hash-compact", hash_compact),
        *words.path("--invariant", invariant),
        *words.integer("--jobs", jobs),
        *words.listed("--no-reduce", no_reduce),
        *words.text("--parametric", parametric),
        *words.flag("--prove", prove),
        *words.path("--sarif", sarif),
        *words.text("--shortest", shortest),
        *words.each("--slice", slice),
        *words.path("--smt", smt),
        *words.flag("--stats", stats),
        *words.path("--store", store),
        *words.flag("--where", where),
        *words.path("--witness", witness),
    ]
    return _calls.check(model, given, scc, progress)

def estimate(
    model: Source,
    *,
    check: Optional[Texts] = None,
    confidence: Optional[Number] = None,
    define: Optional[Mapping[str, Setting]] = None,
    effort: Optional[int] = None,
    free: Optional[str] = None,
    jobs: Optional[int] = None,
    levels: Optional[Union[Number, Path]] = None,
    memory: Optional[int] = None,
    most: Optional[int] = None,
    normal: bool = False,
    property: Optional[Texts] = None,
    runs: Optional[int] = None,
    seconds: Optional[Number] = None,
    seed: Optional[int] = None,
    steps: Optional[int] = None,
    store: Optional[Path] = None,
    until: Optional[Number] = None,
    width: Optional[Number] = None,
    scc: Optional[str] = None,
    progress: Progress = None,
) -> Estimated:
    """Estimates probabilities and means from random runs, as ``scc estimate`` does. Options:

    ``check``: Estimates only the check NAME. May be given several times.
    ``confidence``: An interval misses the number, or an answer is wrong, with a probability of at most 1 less
      C, for each property.
    ``define``: Gives the parameter NAME of the model the value VALUE, a rational. Repeatable.
    ``effort``: With --levels, makes N runs from each level in each repetition. The default is 100.
    ``free``: The treatment of a run where several things are possible and none of them is drawn. With apart the
      run stops there. What is still unknown then counts for no at the lower end of the interval, and for yes at
      the upper end. So the interval contains the least and the greatest probability. With evenly each
      possibility has the same probability; the result is valid only for these choices.
    ``jobs``: How many processes work at the runs.
    ``levels``: Estimates a rare event by splitting, at the levels of LEVELS: 'x(p) >= 1, 2, 3' or 'x(p) >=
      1..9'. See RARE EVENTS.
    ``memory``: Uses at most about N MiB of memory. The default is 3072. If the system limits this process
      (ulimit -v, ulimit -d), the default is no more than about half of what is left when the program has
      started.
    ``most``: Makes at most N runs; the default is 10000. Not with --runs.
    ``normal``: Gives a mean without a proved interval an approximate one, of the normal distribution, and says
      so. It needs 30 runs with another value than the most frequent one.
    ``property``: Estimates PROPERTY, a property that is not in the model: P = ? [ eventually f ]. May be given
      several times.
    ``runs``: Makes N runs, and evaluates once: the intervals are narrower than after as many runs by --width.
      With --levels, makes N repetitions; the default is 100.
    ``seconds``: Makes runs for at most S seconds of the clock. No default.
    ``seed``: An integer. Run k has the seed that is the output number k, from 0 on, of SplitMix64 from this
      integer, and makes its choices by it as scc trace --choose random: does. The runs are the same for any
      --jobs and on every machine.
    ``steps``: Leaves a run after N transitions; the draws and lots of one instant count as one. The default is
      10000 if neither the formulas nor --until end the run at a time, and none otherwise.
    ``store``: Stores the runs in the folder DIR, which is created if necessary, while they are made. The same
      command resumes, and so does one with another --runs, --most, --confidence, --width, --seconds or --jobs.
      See STORES.
    ``until``: Stops a run at the model time TIME, if not all is decided by then; 0 is its first instant. A
      number at TIME is decided only when time has passed.
    ``width``: Makes runs until the interval of a probability is at most W wide, and that of a mean at most this
      share of the mean; of a comparison, until it is decided. The default is 1/20. Not with --runs.

    ``scc``: the program; by default that of the environment variable SCC, or the one that this package carries,
    or the one on the PATH. ``progress``: True shows progress on standard error, and a function gets each line
    of it. The first Ctrl-C ends the command, and the result is what was there then (``interrupted``); the
    second is a KeyboardInterrupt. Raises CommandFailed.
    """
    given = [
        *words.texts("--check", check),
        *words.number("--confidence", confidence),
        *words.define(model, define),
        *words.integer("--effort", effort),
        *words.text("--free", free),
        *words.integer("--jobs", jobs),
        *words.other("--levels", levels),
        *words.integer("--memory", memory),
        *words.integer("--most", most),
        *words.flag("--normal", normal),
        *words.texts("--property", property),
        *words.integer("--runs", runs),
        *words.seconds("--seconds", seconds),
        *words.integer("--seed", seed),
        *words.integer("--steps", steps),
        *words.path("--store", store),
        *words.number("--until", until),
        *words.number("--width", width),
    ]
    return _calls.estimate(model, given, scc, progress)

def simulate(
    model: Source,
    *,
    every: Number,
    observe: Texts,
    runs: int,
    until: Number,
    define: Optional[Mapping[str, Setting]] = None,
    decimals: Optional[int] = None,
    format: str = "jsonl",
    jobs: Optional[int] = None,
    memory: Optional[int] = None,
    output: Optional[Path] = None,
    part: Optional[str] = None,
    plot: Optional[Path] = None,
    quantiles: Optional[Union[str, Sequence[Number]]] = None,
    resume: Optional[Path] = None,
    seed: Optional[int] = None,
    steps: Optional[int] = None,
    store: Optional[Path] = None,
    summary: bool = False,
    view: Optional[Path] = None,
    scc: Optional[str] = None,
    progress: Progress = None,
) -> Simulated:
    """Makes random runs and observes them, as ``scc simulate`` does. Options:

    ``every``: Observes at the multiples of STEP, and at the end.
    ``observe``: Observes FORMULA, any number or predicate of a state that a check can name; a predicate is 1 or
      0. May be given several times.
    ``runs``: How many runs, from number 0 on.
    ``until``: Runs end at the model time TIME; 0 is their first instant.
    ``define``: Gives the parameter NAME of the model the value VALUE, a rational. Repeatable.
    ``decimals``: Writes numbers rounded to K decimals, instead of exactly as texts p/q.
    ``format``: csv (RFC 4180), or jsonl, a JSON object a line.
    ``jobs``: How many processes work at the runs.
    ``memory``: Uses at most about N MiB of memory. The default is 3072. If the system limits this process
      (ulimit -v, ulimit -d), the default is no more than about half of what is left when the program has
      started.
    ``output``: Writes to FILE instead of standard output. - stands for standard output.
    ``part``: Makes only part K of N parts of the runs, with K from 1 on. The lines of all parts, one part after
      the other, without the first line of each but the first, are those of the whole.
    ``plot``: Draws a chart, as SVG: for each observable the mean over the time, and the range from the first to
      the last of --quantiles.
    ``quantiles``: The quantiles of --summary and --plot, by the nearest rank. The default is 1/20,1/2,19/20.
    ``resume``: Continues FILE, written with --format jsonl by a simulation that was interrupted, or had fewer
      runs; an unfinished line is made anew. All options except --runs and --jobs must be the same. The file, or
      -o, becomes what it would be without an interruption. The exit code is about the new runs. --summary does
      not change the file, and summarises its runs together with the new ones, as --plot does; the numbers of
      the file must be exact.
    ``seed``: An integer. Run k has the seed that is the output number k, from 0 on, of SplitMix64 from this
      integer, and makes its choices by it as scc trace --choose random: does. The runs are the same for any
      --jobs and on every machine.
    ``steps``: Ends a run after N transitions; the draws and lots of one instant count as one.
    ``store``: Stores the runs in the folder DIR, which is created if necessary, while they are made. The same
      command resumes, and so does one with another --runs or --jobs, or with another output of the same runs
      (--format, --summary, --plot, --view). See STORES.
    ``summary``: Summarises all runs, for each time and observable: the number of runs with a value, mean,
      variance of the sample, standard deviation, least, quantiles and greatest. All are exact except the
      deviation, which is rounded to --decimals, or 6.
    ``view``: Writes a page that shows the first 20 runs, or fewer if they are large, as scc view does. It has
      the distribution of each observable over all runs, at each time.

    ``scc``: the program; by default that of the environment variable SCC, or the one that this package carries,
    or the one on the PATH. ``progress``: True shows progress on standard error, and a function gets each line
    of it. The first Ctrl-C ends the command, and the result is what was there then (``interrupted``); the
    second is a KeyboardInterrupt. Raises CommandFailed.
    """
    given = [
        *words.number("--every", every),
        *words.texts("--observe", observe),
        *words.integer("--runs", runs),
        *words.number("--until", until),
        *words.define(model, define),
        *words.integer("--decimals", decimals),
        *words.text("--format", format),
        *words.integer("--jobs", jobs),
        *words.integer("--memory", memory),
        *words.path("--output", output),
        *words.text("--part", part),
        *words.path("--plot", plot),
        *words.numbered("--quantiles", quantiles),
        *words.path("--resume", resume),
        *words.integer("--seed", seed),
        *words.integer("--steps", steps),
        *words.path("--store", store),
        *words.flag("--summary", summary),
        *words.path("--view", view),
    ]
    return _calls.simulate(model, given, scc, progress, output=output, resume=resume, summary=summary, format=format)

def sweep(
    model: Source,
    define: Mapping[str, Values],
    *,
    bits: Optional[int] = None,
    depth: Optional[int] = None,
    memory: Optional[int] = None,
    seconds: Optional[Number] = None,
    states: Optional[int] = None,
    time: Optional[Number] = None,
    check: Optional[Texts] = None,
    confidence: Optional[Number] = None,
    decimals: Optional[int] = None,
    estimate: bool = False,
    format: str = "jsonl",
    free: Optional[str] = None,
    jobs: Optional[int] = None,
    most: Optional[int] = None,
    normal: bool = False,
    output: Optional[Path] = None,
    part: Optional[str] = None,
    plot: Optional[Path] = None,
    resume: Optional[Path] = None,
    runs: Optional[int] = None,
    seed: Optional[int] = None,
    steps: Optional[int] = None,
    store: Optional[Path] = None,
    until: Optional[Number] = None,
    width: Optional[Number] = None,
    options: Sequence[str] = (),
    scc: Optional[str] = None,
    progress: Progress = None,
) -> Swept:
    """Checks a model over a grid of parameters, as ``scc sweep`` does. Options:

    ``define``: The values of the parameter NAME: one, 3; a list, 1,2,5; a range with steps of 1, 1..10, or with
      other steps, 0:2:1/8. Repeatable: each value is combined with each of the others, those of the last option
      fastest.
    ``bits``: Expands only states whose numbers all have at most N bits, numerator and denominator together. The
      default is 100000.
    ``depth``: Expands only states that N or fewer transitions lead to. No default.
    ``memory``: Uses at most about N MiB of memory. The default is 3072. If the system limits this process
      (ulimit -v, ulimit -d), the default is no more than about half of what is left when the program has
      started.
    ``seconds``: Explores for at most S seconds of the clock. No default.
    ``states``: Keeps at most N states. The default is 200000.
    ``time``: Expands only states that can be reached by the model time T; 0 is the first instant. No default.
    ``check``: Checks only the property NAME. May be given several times.
    ``confidence``: An interval misses the number, or an answer is wrong, with a probability of at most 1 less
      C, for each property.
    ``decimals``: Writes measured numbers in CSV with K decimals, instead of exactly as texts p/q. The lower end
      is rounded down and the upper one up, so that the number is between them; the names of the columns say so.
    ``estimate``: Estimates the probabilities and means of the checks from runs, as scc estimate does at each
      point, and explores nothing. The table has the columns estimate, from, to and runs.
    ``format``: csv (RFC 4180), a line for each point and check, or jsonl, a JSON object for each point.
    ``free``: The treatment of a run where several things are possible and none of them is drawn. With apart the
      run stops there. What is still unknown then counts for no at the lower end of the interval, and for yes at
      the upper end. So the interval contains the least and the greatest probability. With evenly each
      possibility has the same probability; the result is valid only for these choices.
    ``jobs``: How many processes work at the runs.
    ``most``: Makes at most N runs; the default is 10000. Not with --runs.
    ``normal``: Gives a mean without a proved interval an approximate one, of the normal distribution, and says
      so. It needs 30 runs with another value than the most frequent one.
    ``output``: Writes to FILE instead of standard output. - stands for standard output.
    ``part``: Makes only part K of N parts of the points, with K from 1 on. The lines of all parts, one part
      after the other, without the first line of each but the first, are those of the whole.
    ``plot``: Draws the sweep, as SVG: measured numbers as curves over one parameter; verdicts, and numbers over
      two parameters, as coloured cells.
    ``resume``: Continues FILE, written with --format jsonl by a sweep that was interrupted. All options except
      --jobs must be the same. The exit code is about the new points.
    ``runs``: Makes N runs, and evaluates once: the intervals are narrower than after as many runs by --width.
      With --levels, makes N repetitions; the default is 100.
    ``seed``: An integer. Run k has the seed that is the output number k, from 0 on, of SplitMix64 from this
      integer, and makes its choices by it as scc trace --choose random: does. The runs are the same for any
      --jobs and on every machine.
    ``steps``: Leaves a run after N transitions; the draws and lots of one instant count as one. The default is
      10000 if neither the formulas nor --until end the run at a time, and none otherwise.
    ``store``: Stores the points in the folder DIR, which is created if necessary, while they are computed. The
      same command resumes, and so does one with another --jobs, or with another output of the same points
      (--format, --plot). See STORES.
    ``until``: Stops a run at the model time TIME, if not all is decided by then; 0 is its first instant. A
      number at TIME is decided only when time has passed.
    ``width``: Makes runs until the interval of a probability is at most W wide, and that of a mean at most this
      share of the mean; of a comparison, until it is decided. The default is 1/20. Not with --runs.

    ``scc``: the program; by default that of the environment variable SCC, or the one that this package carries,
    or the one on the PATH. ``progress``: True shows progress on standard error, and a function gets each line
    of it. The first Ctrl-C ends the command, and the result is what was there then (``interrupted``); the
    second is a KeyboardInterrupt. Raises CommandFailed.
    """
    given = [
        *words.grid(model, define),
        *words.integer("--bits", bits),
        *words.integer("--depth", depth),
        *words.integer("--memory", memory),
        *words.seconds("--seconds", seconds),
        *words.integer("--states", states),
        *words.number("--time", time),
        *words.texts("--check", check),
        *words.number("--confidence", confidence),
        *words.integer("--decimals", decimals),
        *words.flag("--estimate", estimate),
        *words.text("--format", format),
        *words.text("--free", free),
        *words.integer("--jobs", jobs),
        *words.integer("--most", most),
        *words.flag("--normal", normal),
        *words.path("--output", output),
        *words.text("--part", part),
        *words.path("--plot", plot),
        *words.path("--resume", resume),
        *words.integer("--runs", runs),
        *words.integer("--seed", seed),
        *words.integer("--steps", steps),
        *words.path("--store", store),
        *words.number("--until", until),
        *words.number("--width", width),
        *options,
    ]
    return _calls.sweep(model, given, scc, progress, output=output, resume=resume, part=part, format=format)

def trace(
    model: Source,
    *,
    choose: Optional[str] = None,
    define: Optional[Mapping[str, Setting]] = None,
    full: bool = False,
    human: bool = False,
    itf: bool = False,
    memory: Optional[int] = None,
    output: Optional[Path] = None,
    schedule: Optional[Path] = None,
    start: Optional[str] = None,
    states: Optional[str] = None,
    steps: Optional[int] = None,
    time: Optional[Number] = None,
    scc: Optional[str] = None,
    progress: Progress = None,
) -> Traced:
    """Follows one run, as ``scc trace`` does. Options:

    ``choose``: How to choose between transitions: first, the first one, or random:SEED. Then draws and lots go
      by their probabilities, and other transitions are equally likely, by the generator SplitMix64 from the
      integer SEED: the same on every machine.
    ``define``: Gives the parameter NAME of the model the value VALUE, a rational. If the parameter has a range,
      it can be narrowed instead: to [1,3], or to [1,3), where a round bracket excludes an end. Repeatable.
    ``full``: With --human: prints every step, every body and all digits of numbers. Without it long numbers are
      decimals: after ~ the nearest one with so many digits, with an error of at most half a unit of the last
      digit; without ~ the number itself.
    ``human``: Prints the run in words instead of JSON Lines. Equal passings of time share a line, and unchanged
      bodies are only named. See --full.
    ``itf``: Writes the run in the Informal Trace Format of Apalache (JSON, by convention in files .itf.json),
      with all numbers as exact integers or pairs of them, and every state in full. Such a trace is no schedule.
    ``memory``: Uses at most about N MiB of memory. The default is 3072. If the system limits this process
      (ulimit -v, ulimit -d), the default is no more than about half of what is left when the program has
      started.
    ``output``: Writes to FILE instead of standard output. - stands for standard output.
    ``schedule``: Makes the choices of FILE: a schedule, as scc check --witness writes it, or a trace, whose
      schedule is used. The run follows it to its end. An impossible choice is an error.
    ``start``: Which start to use where parameters have ranges: simple, simple numbers within the ranges, or
      random:SEED. The latter takes for each parameter one of the 1023 values that divide its range into 1024
      equal parts, by the generator SplitMix64 from the integer SEED. Values that -D or a schedule gives are
      kept, and a range that -D narrows is the one that is sampled. The header of the trace has the values
      (--human: the first line).
    ``states``: Which states to print: all, the one after each transition, or ends, only the first and the last
      one (a line state before the end). With ends a long run of many bodies has one line for each transition.
      Such a trace is its own schedule, too.
    ``steps``: Ends the run after N transitions; each draw and each lot is one. The default is 1000 when neither
      a schedule nor --time ends it.
    ``time``: Ends the run at the model time T, between events if necessary; 0 is its first instant.

    ``scc``: the program; by default that of the environment variable SCC, or the one that this package carries,
    or the one on the PATH. ``progress``: True shows progress on standard error, and a function gets each line
    of it. The first Ctrl-C ends the command, and the result is what was there then (``interrupted``); the
    second is a KeyboardInterrupt. Raises CommandFailed.
    """
    given = [
        *words.text("--choose", choose),
        *words.define(model, define),
        *words.flag("--full", full),
        *words.flag("--human", human),
        *words.flag("--itf", itf),
        *words.integer("--memory", memory),
        *words.path("--output", output),
        *words.path("--schedule", schedule),
        *words.text("--start", start),
        *words.text("--states", states),
        *words.integer("--steps", steps),
        *words.number("--time", time),
    ]
    return _calls.trace(model, given, scc, progress, output=output, human=human, itf=itf)

def view(
    model: Source,
    *,
    bits: Optional[int] = None,
    depth: Optional[int] = None,
    memory: Optional[int] = None,
    seconds: Optional[Number] = None,
    states: Optional[int] = None,
    time: Optional[Number] = None,
    camera: Optional[str] = None,
    check: Optional[str] = None,
    define: Optional[Mapping[str, Setting]] = None,
    data: bool = False,
    from_: Optional[Union[str, Sequence[Number]]] = None,
    graph: Optional[int] = None,
    names: bool = False,
    output: Optional[Path] = None,
    plot: Optional[Texts] = None,
    schedule: Optional[Path] = None,
    svg: Optional[Number] = None,
    trace: Optional[Path] = None,
    up: Optional[Union[str, Sequence[Number]]] = None,
    width: Optional[Number] = None,
    without: Optional[Texts] = None,
    scc: Optional[str] = None,
    progress: Progress = None,
) -> Viewed:
    """Makes a page or a picture of a model, as ``scc view`` does. Options:

    ``bits``: Expands only states whose numbers all have at most N bits, numerator and denominator together. The
      default is 100000.
    ``depth``: Expands only states that N or fewer transitions lead to. No default.
    ``memory``: Uses at most about N MiB of memory. The default is 3072. If the system limits this process
      (ulimit -v, ulimit -d), the default is no more than about half of what is left when the program has
      started.
    ``seconds``: Explores for at most S seconds of the clock. No default.
    ``states``: Keeps at most N states. The default is 200000.
    ``time``: Expands only states that can be reached by the model time T; 0 is the first instant. No default.
    ``camera``: With --svg: sees what a page of scc view shows, in the same frame and perspective. LINK is the
      link that Copy link of the page makes, or what follows # in it.
    ``check``: Shows the check NAME alone.
    ``define``: Gives the parameter NAME of the model the value VALUE, a rational. If the parameter has a range,
      it can be narrowed instead: to [1,3], or to [1,3), where a round bracket excludes an end. Repeatable.
    ``data``: Writes only the data of the page, as JSON (specs/schema/view.schema.json), for other viewers.
    ``from_``: With --svg: looks from the side to which the vector X,Y,Z points: 0,1,0 is from above. Write
      --from=-1,0,0 if it begins with a minus.
    ``graph``: Includes alternatives to the shown runs: at most N states in all. There are fewer if each state
      is large, or if half of --seconds is over.
    ``names``: With --svg: writes the names of bodies into the picture.
    ``output``: Writes to FILE instead of the name of the model with .html, in the present folder. - stands for
      standard output.
    ``plot``: Plots the number NUMBER over time, written as in a check: distance2(p, q). May be given several
      times. Numbers in the checks are always plotted.
    ``schedule``: Shows the run of the schedule FILE, as scc check --witness writes it; then nothing is checked.
    ``svg``: Writes a picture of the state at the model time TIME instead of a page, as SVG, with exact hidden
      surfaces. Walls that hide a body entirely are drawn as glass. The run is that of --schedule or --trace,
      that which shows the verdict of --check, or that of the first choices.
    ``trace``: Shows the run of a trace, as scc trace writes it; then nothing is checked.
    ``up``: With --svg: the direction that is upwards in the picture, by default the y axis, or another axis if
      the view is along it.
    ``width``: With --svg: the width of the picture, in pixels.
    ``without``: With --svg: leaves out NAME, a body, a part of one such as a wall that hides what is behind it
      (room.south), or a family of bodies. May be given several times.

    ``scc``: the program; by default that of the environment variable SCC, or the one that this package carries,
    or the one on the PATH. ``progress``: True shows progress on standard error, and a function gets each line
    of it. The first Ctrl-C ends the command, and the result is what was there then (``interrupted``); the
    second is a KeyboardInterrupt. Raises CommandFailed.
    """
    given = [
        *words.integer("--bits", bits),
        *words.integer("--depth", depth),
        *words.integer("--memory", memory),
        *words.seconds("--seconds", seconds),
        *words.integer("--states", states),
        *words.number("--time", time),
        *words.text("--camera", camera),
        *words.text("--check", check),
        *words.define(model, define),
        *words.flag("--data", data),
        *words.numbered("--from", from_),
        *words.integer("--graph", graph),
        *words.flag("--names", names),
        *words.path("--output", output),
        *words.texts("--plot", plot),
        *words.path("--schedule", schedule),
        *words.number("--svg", svg),
        *words.path("--trace", trace),
        *words.numbered("--up", up),
        *words.number("--width", width),
        *words.texts("--without", without),
    ]
    return _calls.view(model, given, scc, progress, output=output)
