#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trains the weights of one round of the learned estimator (python3-torch, python3-numpy).

    train.py gate|sheets|correction RECORDS... --out weights.txt [--epochs N] [--seed S]

RECORDS are files of record_features or record_sheets. One cloud of ten is for validation. The network is that of
Learned_network.h; its weights are written in the order in which they are stored there.
"""
import argparse
import math
import time

import numpy as np
import torch

EDGES = 32
HIDDEN, GATES, HEAD = 16, 4, 20


class Network(torch.nn.Module):
    """Learned_network.h"""

    def __init__(self, edge_even, edge_odd, point_even, point_odd):
        super().__init__()
        self.numbers_even, self.numbers_point_even = edge_even, point_even
        odd_inputs = GATES * (edge_odd + 1) + point_odd

        def weights(rows, columns, scale=1.0):
            return torch.nn.Parameter(torch.randn(rows, columns) * scale / math.sqrt(columns))

        self.edge_even = weights(HIDDEN, edge_even)
        self.edge_bias = torch.nn.Parameter(torch.rand(HIDDEN) - 0.5)
        self.edge_odd = weights(HIDDEN, edge_odd)
        self.point_even = weights(HIDDEN, point_even, 0.3)
        self.point_odd = weights(HIDDEN, point_odd, 0.3)
        self.gate = weights(GATES, HIDDEN, 0.5)
        self.gate_bias = torch.nn.Parameter(torch.zeros(GATES))
        self.head_even = weights(HEAD, HIDDEN + point_even + GATES, 0.7)
        self.head_bias = torch.nn.Parameter(torch.rand(HEAD) - 0.5)
        self.head_odd = weights(HEAD, HIDDEN + odd_inputs, 0.7)
        self.factor = weights(odd_inputs, HEAD, 0.1)
        self.factor_bias = torch.nn.Parameter(torch.zeros(odd_inputs))
        self.rest = weights(HEAD, 1, 0.1)
        self.even = weights(HEAD, 1, 0.1)
        self.even_bias = torch.nn.Parameter(torch.zeros(1))

    def forward(self, even, odd, mask, point_even, point_odd):
        """even and odd (n, features, 32), mask (n, 32), point_even and point_odd (n, features)"""
        inverse = 1.0 / mask.sum(1, keepdim=True)
        e = torch.matmul(self.edge_even, even) + (self.edge_bias + point_even @ self.point_even.T)[:, :, None]
        o = torch.matmul(self.edge_odd, odd) + (point_odd @ self.point_odd.T)[:, :, None]
        p, m = torch.relu(e + o), torch.relu(e - o)
        both, difference = p + m, p - m
        g = torch.matmul(self.gate, both) + self.gate_bias[:, None]
        weight = 0.5 * (g + torch.sqrt(g * g + 1.0)) * mask[:, None]
        total = weight.sum(2)
        values = torch.cat([odd, 0.5 * (odd[:, :1] + odd[:, 1:2])], 1)
        means = torch.matmul(weight, values.transpose(1, 2)) / (total[:, :, None] + 0.001)
        odd_inputs = torch.cat([means.flatten(1), point_odd], 1)
        mean_even = (both * mask[:, None]).sum(2) * inverse
        mean_odd = (difference * mask[:, None]).sum(2) * inverse
        shares = torch.log(total * inverse + 0.001)
        e = torch.cat([mean_even, point_even, shares], 1) @ self.head_even.T + self.head_bias
        o = torch.cat([mean_odd, odd_inputs], 1) @ self.head_odd.T
        p, m = torch.relu(e + o), torch.relu(e - o)
        factors = (p + m) @ self.factor.T + self.factor_bias
        return (factors * odd_inputs).sum(1) + ((p - m) @ self.rest)[:, 0], ((p + m) @ self.even)[:, 0] + self.even_bias


def squashed(x):
    return x / torch.sqrt(1.0 + x * x / 16.0)


class Task:
    """Records, and what is learned from them"""

    def __init__(self, files):
        width = self.HEADER + sum(self.POINT) + EDGES * sum(self.EDGE)
        rows = [np.fromfile(f, np.float32) for f in files]
        rows = [r[: len(r) // width * width].reshape(-1, width) for r in rows]
        self.rows = torch.from_numpy(np.concatenate(rows))
        self.cloud = self.rows[:, 0].to(torch.int64)
        self.network = Network(*self.EDGE, *self.POINT)

    def outputs(self, rows):
        mask = (torch.arange(EDGES)[None] < rows[:, self.HEADER - 1 : self.HEADER]).to(torch.float32)
        point = rows[:, self.HEADER : self.HEADER + sum(self.POINT)]
        edges = rows[:, self.HEADER + sum(self.POINT) :].reshape(len(rows), -1, EDGES)
        e, p = self.EDGE[0], self.POINT[0]
        return self.network(edges[:, :e], edges[:, e:], mask, point[:, :p], point[:, p:])


class Correction(Task):
    """The movement to the surface. Header: cloud, rms error, unit, movement in units, size"""

    HEADER, EDGE, POINT = 5, (2, 3), (2, 1)

    @staticmethod
    def errors(rows, movement):
        """In the rms error of the cloud, so that all clouds count alike"""
        least = 0.02 * rows[:, 2]
        return (movement - rows[:, 3]) * rows[:, 2] / torch.maximum(rows[:, 1], least)

    def loss(self, index):
        rows = self.rows[index]
        error = self.errors(rows, self.outputs(rows)[0])
        return torch.nn.functional.huber_loss(error, torch.zeros_like(error), delta=2.0)

    def validate(self, index):
        """The geometric mean over the clouds of the rms error after to that before"""
        sums = {}
        for part in index.split(8192):
            rows = self.rows[part]
            before = self.errors(rows, torch.zeros(len(rows)))
            after = self.errors(rows, self.outputs(rows)[0].clamp(-2, 2))
            usual = before.abs() < 6
            for c, b, a in zip(self.cloud[part][usual].tolist(), before[usual].tolist(), after[usual].tolist()):
                s = sums.setdefault(c, [0.0, 0.0])
                s[0] += b * b
                s[1] += a * a
        ratios = sorted(math.sqrt(a / (b + 1e-12)) for b, a in sums.values())
        mean = math.exp(sum(map(math.log, ratios)) / len(ratios))
        return f"error {mean:.4f} of that before, worst {ratios[-1]:.3f} {ratios[-2]:.3f} {ratios[-3]:.3f}"


class Sheets(Task):
    """Whether there are two sheets, and on which one a point is. Header: cloud, share of opposite neighbors, cosine,
    inputs of the gate, size"""

    HEADER, EDGE, POINT = 7, (3, 3), (4, 2)
    SHARE = 0.12

    def loss(self, index):
        rows = self.rows[index]
        side, two = self.outputs(rows)
        is_two = (rows[:, 1] > self.SHARE).to(torch.float32)
        certain = ((rows[:, 1] - self.SHARE).abs() * 10).clamp(0, 1)
        is_up = (rows[:, 2] > 0).to(torch.float32)
        entropy = torch.nn.functional.binary_cross_entropy_with_logits
        return (entropy(squashed(two), is_two, reduction="none") * certain).mean() + (
            entropy(squashed(side), is_up, reduction="none") * is_two * rows[:, 2].abs()).sum() / (is_two.sum() + 1)

    def validate(self, index):
        counts = dict.fromkeys(("two", "found", "right", "one", "wrongly", "sided"), 0.0)
        for part in index.split(8192):
            rows = self.rows[part]
            side, two = self.outputs(rows)
            is_two, is_one = rows[:, 1] > self.SHARE, rows[:, 1] < 0.02
            found = (squashed(two) > 0) & (squashed(side).abs() > 1)
            right = found & ((side > 0) == (rows[:, 2] > 0))
            for name, which in (("two", is_two), ("found", is_two & (squashed(two) > 0)), ("right", is_two & right), ("sided", is_two & found), ("one", is_one),
                                ("wrongly", is_one & found)):
                counts[name] += which.sum().item()
        c = counts
        return (f"two sheets: {c['found'] / c['two']:.3f} found, {c['sided'] / c['two']:.3f} with a side, {c['right'] / max(1, c['sided']):.3f} right;"
                f" one sheet: {c['wrongly'] / c['one']:.3f} with a side")


def fit_gate(task, out, kept=0.95):
    """Logistic regression on what the round before found: records are of round 1. Writes the weights so that the
    gate opens for so many of the points that were rightly found."""
    x = task.rows[:, 3:6]
    pairs = [x[:, i] * x[:, j] for i in range(3) for j in range(i, 3)]
    x = torch.stack([x[:, 0], x[:, 1], x[:, 2], *pairs, torch.ones(len(x))], 1)
    scale = x.abs().mean(0)
    found = (task.rows[:, task.HEADER + 3] > -1) & (task.rows[:, 1] > Sheets.SHARE)
    weights = torch.zeros(x.shape[1], requires_grad=True)
    optimizer = torch.optim.LBFGS([weights], max_iter=500, line_search_fn="strong_wolfe")

    def loss():
        optimizer.zero_grad()
        value = torch.nn.functional.binary_cross_entropy_with_logits((x / scale) @ weights, found.to(torch.float32))
        value.backward()
        return value

    optimizer.step(loss)
    weights = weights.detach() / scale
    score = x @ weights
    least = np.quantile(score[found].numpy(), 1 - kept)
    weights[-1] -= least
    one = task.rows[:, 1] < 0.02
    print(f"the gate opens for {kept} of what is found, and for {(score[one] > least).float().mean():.3f} of one sheet")
    with open(out, "w") as file:
        file.write(" ".join(f"{w:.7g}" for w in weights.tolist()) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("task", choices=("gate", "sheets", "correction"))
    parser.add_argument("records", nargs="+")
    parser.add_argument("--out", required=True)
    parser.add_argument("--epochs", type=int, default=12)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int, default=1)
    options = parser.parse_args()
    torch.manual_seed(options.seed)
    torch.set_num_threads(options.threads)
    task = {"gate": Sheets, "correction": Correction, "sheets": Sheets}[options.task](options.records)
    if options.task == "gate":
        fit_gate(task, options.out)
        return
    is_for_validation = task.cloud % 10 == 0
    training = torch.nonzero(~is_for_validation)[:, 0]
    validation = torch.nonzero(is_for_validation)[:, 0]
    parameters = list(task.network.parameters())
    print(f"{len(training)} records for training, {len(validation)} for validation,",
          sum(p.numel() for p in parameters), "weights")
    batch_size = 1024
    steps = options.epochs * (len(training) // batch_size)
    optimizer = torch.optim.Adam(parameters, lr=4e-3)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimizer, 5e-3, total_steps=steps + 1, pct_start=0.1)
    start = time.time()
    for epoch in range(options.epochs):
        order = training[torch.randperm(len(training))]
        total = count = 0
        for part in order.split(batch_size)[: len(training) // batch_size]:
            loss = task.loss(part)
            optimizer.zero_grad()
            loss.backward()
            optimizer.step()
            schedule.step()
            total, count = total + loss.item(), count + 1
        with torch.no_grad():
            result = task.validate(validation)
        print(f"epoch {epoch}: loss {total / count:.4f}, {result}, {time.time() - start:.0f} s", flush=True)
        with open(options.out, "w") as out:
            for parameter in parameters:
                out.write(" ".join(f"{x:.7g}" for x in parameter.detach().flatten().tolist()) + "\n")


if __name__ == "__main__":
    main()
